package org.u2sa.sim.device;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import org.u2sa.device.Device;
import org.u2sa.sim.motion.Arguments;

/**
 * A device that measures the truth at its own rate and can be unplugged. The truth is asked for on
 * the thread that reads; {@link #plug} may come from any.
 */
public abstract class SimulatedDevice<R extends Device.Reading> implements Device<R> {
  private static final double MICROS_PER_S = 1e6;
  private static final long NOT_YET = Long.MIN_VALUE;

  private final long periodMicros;
  private final long latencyMicros;
  private final Deque<R> underWay = new ArrayDeque<>(); // measured, not delivered
  private Optional<R> latest = Optional.empty();
  private long beganMicros = NOT_YET;
  private long dueMicros = NOT_YET;
  private int seen;
  private volatile boolean isPlugged = true;
  private volatile int connections = 1;

  /**
   * @param latencyS from a measurement to its arrival [s]; the reading has the time of arrival, as
   *     those of real devices
   */
  SimulatedDevice(double rateHz, double latencyS) {
    Arguments.requireInside("rate of a device", rateHz, 0.1, 10_000.0);
    periodMicros = Math.round(MICROS_PER_S / rateHz);
    latencyMicros = Math.round(latencyS * MICROS_PER_S);
  }

  /**
   * Measures.
   *
   * @param timeS since the first reading [s], more than at the last call
   * @param measuredAtMicros for the reading [µs of the run's clock]
   */
  abstract R measure(double timeS, long measuredAtMicros);

  /** Whether the measurement that is due gets lost. */
  boolean isDropped() {
    return false;
  }

  /** Hears from its service: at each read while it is plugged in. */
  void tell(long nowMicros) {}

  /** Whether a reading outlives the loss of the device. */
  boolean outlivesLoss() {
    return true;
  }

  @Override
  public final Optional<R> read(long nowMicros) {
    if (!isPlugged || connections != seen) {
      seen = isPlugged ? connections : seen;
      underWay.clear();
      latest = outlivesLoss() ? latest : Optional.empty();
    }
    if (isPlugged) {
      tell(nowMicros);
    }
    if (isPlugged && (dueMicros == NOT_YET || nowMicros >= dueMicros)) {
      beganMicros = beganMicros == NOT_YET ? nowMicros : beganMicros;
      dueMicros = (nowMicros / periodMicros + 1) * periodMicros;
      if (!isDropped()) {
        underWay.add(measure((nowMicros - beganMicros) / MICROS_PER_S, nowMicros + latencyMicros));
      }
    }
    while (!underWay.isEmpty() && underWay.peek().measuredAtMicros() <= nowMicros) {
      latest = Optional.of(underWay.remove());
    }
    return latest;
  }

  /** Plugs the device in or pulls it out. */
  public final synchronized void plug(boolean in) {
    connections += in && !isPlugged ? 1 : 0;
    isPlugged = in;
  }

  @Override
  public final boolean isConnected() {
    return isPlugged;
  }

  @Override
  public final int connections() {
    return connections;
  }

  @Override
  public final String trouble() {
    return isPlugged ? "" : "unplugged";
  }
}
