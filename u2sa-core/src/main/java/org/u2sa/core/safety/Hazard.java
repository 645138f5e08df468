package org.u2sa.core.safety;

import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.messages.contract.FailsafeAction;

/** What can be wrong with a vehicle on its way, each with its entry in the failsafe matrix. */
enum Hazard {
  OPERATOR("operator link", "ON OPERATOR LOSS", FailsafeAction.RETURN),
  POSITION("position", "ON POSITION LOSS", FailsafeAction.HOLD),
  ESTIMATOR("state estimator", "ON ESTIMATOR LOSS", FailsafeAction.HOLD),
  ACTUATOR_LINK("actuator link", "ON ACTUATOR LINK LOSS", FailsafeAction.HOLD),
  ACTUATION("actuation refused", "ON ACTUATION REFUSED", FailsafeAction.HOLD),
  HEALTH_MONITOR("health monitor", "ON HEALTH MONITOR LOSS", FailsafeAction.CONTINUE),
  SERVICE("service given up", "ON SERVICE LOSS", FailsafeAction.HOLD),
  LOW_BATTERY("low battery", "ON LOW BATTERY", FailsafeAction.RETURN),
  CRITICAL_BATTERY("critical battery", "ON CRITICAL BATTERY", FailsafeAction.RETURN),
  FENCE("geofence", "ON FENCE", FailsafeAction.RETURN);

  private final String words;
  private final VariableDeclaration<String> action;

  Hazard(String words, String variable, FailsafeAction ifAbsent) {
    this.words = words;
    action =
        VariableDeclaration.text(variable)
            .oneOf(
                FailsafeAction.CONTINUE.name(),
                FailsafeAction.HOLD.name(),
                FailsafeAction.RETURN.name(),
                FailsafeAction.LAND.name(),
                FailsafeAction.STOP.name())
            .ifAbsent(ifAbsent.name())
            .describedAs("Failsafe matrix: what the vehicle does because of this: " + words + ".");
  }

  /** What it is called in causes. */
  String words() {
    return words;
  }

  /** The variable that says what is done about it. */
  VariableDeclaration<String> action() {
    return action;
  }
}
