package org.u2sa.drivers.motor;

import java.util.OptionalDouble;
import org.u2sa.device.SlewLimit;

/**
 * One servo or speed control: from what an actuator should do to the pulse that it gets. Not safe
 * for several threads.
 */
public final class PulseOutput {
  private final PulseWidth width;
  private final SlewLimit slew;

  /** At neutral. */
  public PulseOutput(PulseWidth width, SlewLimit slew) {
    this.width = width;
    this.slew = slew;
  }

  /**
   * The pulse to give now [s].
   *
   * @param percentage as {@link org.u2sa.service.CommandedActuators#percentage} says; empty is
   *     neutral at once, without slew limit
   * @param nowMicros time of the run's clock [µs]
   */
  public double seconds(OptionalDouble percentage, long nowMicros) {
    if (percentage.isEmpty()) {
      slew.rest(nowMicros);
      return width.neutralS();
    }
    return width.seconds(slew.towards(percentage.getAsDouble(), nowMicros));
  }

  /** The pulse at which nothing moves [s]. */
  public double neutralS() {
    return width.neutralS();
  }
}
