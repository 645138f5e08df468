package org.u2sa.core.safety;

import java.util.Arrays;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.messages.contract.FailsafeAction;

/** What can go wrong with a moving vehicle, each with its entry in the failsafe matrix. */
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
                Arrays.stream(FailsafeAction.values())
                    .map(FailsafeAction::name)
                    .toArray(String[]::new))
            .ifAbsent(ifAbsent.name())
            .describedAs("Failsafe matrix: action on " + words + ".");
  }

  /** What it is called in causes. */
  String words() {
    return words;
  }

  /** What the matrix says to do about it. */
  FailsafeAction action(Configurator matrix) {
    return FailsafeAction.valueOf(matrix.getVariable(action));
  }

  /** The name of its variable. */
  String variable() {
    return action.name();
  }
}
