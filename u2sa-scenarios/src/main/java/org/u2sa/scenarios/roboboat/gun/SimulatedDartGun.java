package org.u2sa.scenarios.roboboat.gun;

import java.util.OptionalDouble;
import java.util.function.LongConsumer;
import org.u2sa.device.payload.SwitchOutput;
import org.u2sa.sim.device.SimulatedPayload;

/** The trigger of a dart gun: each change from below half to above fires one dart. */
public final class SimulatedDartGun extends SimulatedPayload<SwitchOutput.Level>
    implements SwitchOutput {
  private static final double RATE_HZ = 50.0;
  private static final double HALF_PERCENT = 50.0;

  private final LongConsumer fired;
  private OptionalDouble wanted = OptionalDouble.empty();
  private boolean isPulled;

  /**
   * @param fired called with the time of each shot [µs of the run's clock]
   */
  public SimulatedDartGun(LongConsumer fired) {
    super(RATE_HZ, 0.0);
    this.fired = fired;
  }

  @Override
  protected void advance(long nowMicros) {
    boolean pulls = wanted.orElse(0.0) > HALF_PERCENT;
    if (pulls && !isPulled) {
      fired.accept(nowMicros);
    }
    isPulled = pulls;
  }

  @Override
  protected Level sense(long stampMicros) {
    return new Level(stampMicros, wanted);
  }

  @Override
  public void set(double percent) {
    wanted = OptionalDouble.of(percent);
  }

  @Override
  public void leave() {
    // the trigger keeps its position
  }

  @Override
  public void close() {
    // likewise
  }
}
