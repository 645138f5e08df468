package org.u2sa.control.ground;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.interfaces.configuration.Variable;

/** The two motors of a differential vehicle. */
record Motors(
    @Variable(ifAbsentText = "LEFT MOTOR", text = "Actuator of the left side, forward positive.")
        String leftActuator,
    @Variable(ifAbsentText = "RIGHT MOTOR", text = "Actuator of the right side, forward positive.")
        String rightActuator,
    @Variable(
            unit = "%",
            min = 0,
            max = 95,
            ifAbsent = 80,
            text =
                "Maximum by which feedback raises the weaker motor's command and lowers the stronger one's.")
        double mismatchLimit) {
  List<String> names() {
    return List.of(leftActuator, rightActuator);
  }

  Map<String, Double> neutral() {
    Map<String, Double> all = new LinkedHashMap<>(); // Map.of's order varies by process
    all.put(leftActuator, 0.0);
    all.put(rightActuator, 0.0);
    return all;
  }
}
