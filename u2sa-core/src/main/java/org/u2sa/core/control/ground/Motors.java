package org.u2sa.core.control.ground;

import java.util.Map;
import org.u2sa.interfaces.configuration.Variable;

/** The two motors of a differential vehicle. */
record Motors(
    @Variable(
            ifAbsentText = "LEFT MOTOR",
            text = "Name of the actuator of the left side, forwards positive.")
        String leftActuator,
    @Variable(
            ifAbsentText = "RIGHT MOTOR",
            text = "Name of the actuator of the right side, forwards positive.")
        String rightActuator,
    @Variable(
            unit = "%",
            min = 0,
            max = 95,
            ifAbsent = 80,
            text =
                "Most by which feedback commands the weaker motor more and the stronger one less.")
        double mismatchLimit) {
  Map<String, Double> neutral() {
    return Map.of(leftActuator, 0.0, rightActuator, 0.0);
  }
}
