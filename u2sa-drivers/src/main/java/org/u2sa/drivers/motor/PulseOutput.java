package org.u2sa.drivers.motor;

import java.util.OptionalDouble;
import org.u2sa.device.SlewLimit;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Variable;

/**
 * One servo or speed control: from what an actuator should do to the pulse that it gets. Not safe
 * for several threads.
 */
public final class PulseOutput {
  private final PulseWidth width;
  private final SlewLimit slew;

  private record Tuning(
      @Variable(
              unit = "%/s",
              min = 1,
              max = 100_000,
              ifAbsent = 400,
              text = "Fastest change; a stop is not limited.")
          double slewLimit) {}

  /**
   * The output that the variables describe whose names begin with an actuator's.
   *
   * @throws org.u2sa.interfaces.configuration.ConfigurationException if one is wrong
   */
  public static PulseOutput configured(Configurator variables, String actuator) {
    String prefix = actuator + " ";
    PulseWidth width = variables.settings(PulseWidth.class, prefix).get();
    return new PulseOutput(
        width, new SlewLimit(variables.settings(Tuning.class, prefix).get().slewLimit()));
  }

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
