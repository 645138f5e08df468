package org.u2sa.sim.device;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.Random;
import java.util.function.DoubleSupplier;
import org.u2sa.device.port.Device;
import org.u2sa.sim.motion.Arguments;

/**
 * A device that samples the truth at its own rate and can be unplugged. The truth is sampled on the
 * reading thread; {@link #plug} may be called from any thread.
 */
public abstract class SimulatedDevice<R extends Device.Reading> implements Device<R> {
  private static final double MICROS_PER_S = 1e6;
  private static final long NOT_YET = Long.MIN_VALUE;

  private final long periodMicros;
  private long latencyMicros;
  private final Deque<R> underWay = new ArrayDeque<>(); // measured, not delivered
  private Optional<R> latest = Optional.empty();
  private long beganMicros = NOT_YET;
  private long dueMicros = NOT_YET;
  private int seen;
  private double lost;
  private Random losses = new Random(0);
  private double failsAtS = Double.POSITIVE_INFINITY;
  private DoubleSupplier vehicleTimeS = () -> 0.0;
  private volatile boolean isPlugged = true;
  private volatile int connections = 1;

  /**
   * @param latencyS from a measurement to its arrival [s]; as with real devices, the reading is
   *     stamped with its arrival time
   */
  protected SimulatedDevice(double rateHz, double latencyS) {
    Arguments.requireInside("rate of a device", rateHz, 0.1, 10_000.0);
    periodMicros = Math.round(MICROS_PER_S / rateHz);
    latencyMicros = Math.round(latencyS * MICROS_PER_S);
  }

  /**
   * Takes a measurement.
   *
   * @param timeS time since the first reading [s], strictly increasing
   * @param measuredAtMicros timestamp of the reading [µs, run's clock]
   */
  protected abstract R measure(double timeS, long measuredAtMicros);

  /**
   * Adds delay and loss to a device whose model has none; call before the first reading.
   *
   * @param latencyS from a measurement to its arrival [s]
   * @param share fraction of lost measurements, 0…1
   * @param random decides which are lost
   */
  public final void degrade(double latencyS, double share, Random random) {
    latencyMicros += Math.round(latencyS * MICROS_PER_S);
    lost = share;
    losses = random;
  }

  /**
   * Unplugs the device permanently at the given time.
   *
   * @param timeS time of the vehicle [s]; infinite for never
   * @param vehicleS current time of the vehicle [s]
   */
  public final void failAt(double timeS, DoubleSupplier vehicleS) {
    failsAtS = timeS;
    vehicleTimeS = vehicleS;
  }

  /** Whether the next measurement is lost. */
  boolean isDropped() {
    return lost > 0.0 && losses.nextDouble() < lost;
  }

  /**
   * The device side of its serial line, to be used instead of {@link #read}; empty if it has no
   * protocol. Returns a new one on each call.
   */
  public Optional<SerialInstrument> serial() {
    return Optional.empty();
  }

  /** Called at each read while the device is plugged in. */
  void tell(long nowMicros) {}

  /** Whether the last reading is kept after the device is unplugged. */
  boolean outlivesLoss() {
    return true;
  }

  @Override
  public final Optional<R> read(long nowMicros) {
    if (failsAtS < Double.POSITIVE_INFINITY && vehicleTimeS.getAsDouble() >= failsAtS) {
      plug(false);
    }
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

  /** Plugs the device in or unplugs it. */
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
