package org.u2sa.drivers.motor;

import java.util.OptionalDouble;
import org.u2sa.device.SlewLimit;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** Converts an actuator command to a servo or ESC pulse. Not thread-safe. */
public final class PulseOutput {
  private final PulseWidth width;
  private final SlewLimit slew;

  private record Variables(
      @Variable(unit = "%/s", min = 1, max = 100_000, ifAbsent = 400)
          @Description("Maximum rate of change; stops are not limited.")
          double slewLimit) {}

  /**
   * Creates the output from the variables prefixed with an actuator's name.
   *
   * @throws org.u2sa.interfaces.configuration.ConfigurationException if a variable is invalid
   */
  public static PulseOutput configured(Configurator variables, String actuator) {
    String prefix = actuator + " ";
    PulseWidth width = variables.settings(PulseWidth.class, prefix).get();
    return new PulseOutput(
        width, new SlewLimit(variables.settings(Variables.class, prefix).get().slewLimit()));
  }

  /** Creates an output at neutral. */
  public PulseOutput(PulseWidth width, SlewLimit slew) {
    this.width = width;
    this.slew = slew;
  }

  /**
   * Current pulse width [s].
   *
   * @param percentage from {@link org.u2sa.service.CommandedActuators#percentage}; empty means
   *     neutral immediately, without slew limit
   * @param nowMicros time of the run's clock [µs]
   */
  public double seconds(OptionalDouble percentage, long nowMicros) {
    if (percentage.isEmpty()) {
      slew.rest(nowMicros);
      return width.neutralS();
    }
    return width.seconds(slew.towards(percentage.getAsDouble(), nowMicros));
  }
}
