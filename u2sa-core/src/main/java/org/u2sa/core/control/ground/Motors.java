package org.u2sa.core.control.ground;

import java.util.Map;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.VariableDeclaration;

/** The names of the two motors of a differential vehicle. */
final class Motors {
  static final VariableDeclaration<String> LEFT =
      VariableDeclaration.text("LEFT ACTUATOR")
          .ifAbsent("LEFT MOTOR")
          .describedAs("Name of the actuator of the left side, forwards positive.");
  static final VariableDeclaration<String> RIGHT =
      VariableDeclaration.text("RIGHT ACTUATOR")
          .ifAbsent("RIGHT MOTOR")
          .describedAs("Name of the actuator of the right side, forwards positive.");

  static final VariableDeclaration<Double> MISMATCH_LIMIT =
      PursuitVariables.number(
          "MISMATCH LIMIT",
          "%",
          0.0,
          95.0,
          80.0,
          "Most by which feedback commands the weaker motor more and the stronger one less.");

  private Motors() {}

  static void declare(Configurator configuration) {
    configuration.getVariable(LEFT);
    configuration.getVariable(RIGHT);
    configuration.getVariable(MISMATCH_LIMIT);
  }

  static String left(Configurator configuration) {
    return configuration.getVariable(LEFT);
  }

  static String right(Configurator configuration) {
    return configuration.getVariable(RIGHT);
  }

  static Map<String, Double> neutral(Configurator configuration) {
    return Map.of(left(configuration), 0.0, right(configuration), 0.0);
  }
}
