package org.u2sa.drivers.motor;

import org.u2sa.device.SlewLimit;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;

/** The configuration variables of a servo output; their names begin with the actuator's. */
public final class PulseVariables {
  private static final Range PULSE_US = Range.of(100.0, 5000.0);

  private PulseVariables() {}

  /**
   * Declares and reads the variables of one output.
   *
   * @param actuator its name, as in "LEFT MOTOR"
   * @throws BadInputException naming the actuator, if minimum, neutral and maximum are not in order
   */
  public static PulseOutput read(Configurator variables, String actuator) {
    double minimumUs =
        variables.getVariable(
            pulse(actuator + " SHORTEST PULSE", 1000.0, "Pulse at -100 %, or 100 % if reversed."));
    double neutralUs =
        variables.getVariable(
            pulse(actuator + " NEUTRAL PULSE", 1500.0, "Pulse at which nothing moves."));
    double maximumUs =
        variables.getVariable(
            pulse(actuator + " LONGEST PULSE", 2000.0, "Pulse at 100 %, or -100 % if reversed."));
    boolean reversed =
        variables.getVariable(
            VariableDeclaration.flag(actuator + " REVERSED")
                .ifAbsent(false)
                .describedAs("Whether it turns the wrong way."));
    double deadBand =
        variables.getVariable(
            VariableDeclaration.number(actuator + " DEAD BAND", "%")
                .range(Range.of(0.0, 100.0))
                .ifAbsent(0.0)
                .describedAs("Percentages not farther from 0 than this are neutral."));
    double slew =
        variables.getVariable(
            VariableDeclaration.number(actuator + " SLEW LIMIT", "%/s")
                .range(Range.of(1.0, 100_000.0))
                .ifAbsent(400.0)
                .describedAs("Fastest change; a stop is not limited."));
    try {
      return new PulseOutput(
          new PulseWidth(minimumUs, neutralUs, maximumUs, reversed, deadBand), new SlewLimit(slew));
    } catch (BadInputException e) {
      throw new BadInputException(actuator + ": " + e.getMessage(), e);
    }
  }

  private static VariableDeclaration<Double> pulse(String name, double us, String description) {
    return VariableDeclaration.number(name, "us")
        .range(PULSE_US)
        .ifAbsent(us)
        .describedAs(description);
  }
}
