package org.u2sa.control.ground;

import java.util.List;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** The two motors of a differential vehicle. */
record Motors(
    @Variable(ifAbsentText = "LEFT MOTOR")
        @Description("Actuator of the left side, forward positive.")
        String leftActuator,
    @Variable(ifAbsentText = "RIGHT MOTOR")
        @Description("Actuator of the right side, forward positive.")
        String rightActuator,
    @Variable(unit = "%", min = 0, max = 95, ifAbsent = 80)
        @Description(
            "Maximum correction by feedback: raises the weaker motor's command and lowers the stronger motor's.")
        double mismatchLimit) {
  List<String> names() {
    return List.of(leftActuator, rightActuator);
  }
}
