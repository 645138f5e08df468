package org.u2sa.sim.payload;

import java.util.OptionalDouble;
import org.u2sa.device.payload.SwitchOutput;
import org.u2sa.sim.device.SimulatedPayload;

/** A switched payload that takes some time to move from 0 to 100 %. */
public final class SimulatedSwitch extends SimulatedPayload<SwitchOutput.Level>
    implements SwitchOutput {
  private static final double MICROS_PER_S = 1e6;
  private static final double FULL_PERCENT = 100.0;

  private final double timeS;
  private OptionalDouble wanted = OptionalDouble.empty();
  private volatile OptionalDouble level = OptionalDouble.empty();
  private long atMicros = Long.MIN_VALUE;

  /**
   * @param rateHz readings per second
   * @param timeS time from 0 to 100 % [s]; 0: immediate
   */
  public SimulatedSwitch(double rateHz, double timeS) {
    super(rateHz, 0.0);
    this.timeS = timeS;
  }

  /** Current level [%]; 0 until first set. Thread-safe. */
  public double percent() {
    return level.orElse(0.0);
  }

  @Override
  protected void advance(long nowMicros) {
    double passedS = atMicros == Long.MIN_VALUE ? 0.0 : (nowMicros - atMicros) / MICROS_PER_S;
    atMicros = nowMicros;
    if (wanted.isEmpty()) {
      return;
    }
    double toGo = wanted.getAsDouble() - level.orElse(wanted.getAsDouble());
    double most = timeS > 0.0 ? FULL_PERCENT * passedS / timeS : FULL_PERCENT;
    double left = Math.abs(toGo) <= most ? 0.0 : Math.copySign(Math.abs(toGo) - most, toGo);
    level = OptionalDouble.of(wanted.getAsDouble() - left);
  }

  @Override
  protected Level sense(long stampMicros) {
    return new Level(stampMicros, level);
  }

  @Override
  public void set(double percent) {
    wanted = OptionalDouble.of(Math.max(0.0, Math.min(FULL_PERCENT, percent)));
  }

  @Override
  public void leave() {
    // keeps its position
  }

  @Override
  public void close() {
    // keeps its position
  }
}
