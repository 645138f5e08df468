package org.u2sa.core.safety;

import java.util.Arrays;
import java.util.List;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.messages.safety.FailsafeAction;

/** Hazards of a moving vehicle, each with an entry in the failsafe matrix. */
final class Hazard {
  static final Hazard OPERATOR =
      new Hazard("operator link", "ON OPERATOR LOSS", FailsafeAction.RETURN);
  static final Hazard OPERATOR_FOR_LONG =
      new Hazard("operator link for long", "ON LONG OPERATOR LOSS", FailsafeAction.RETURN);
  static final Hazard POSITION = new Hazard("position", "ON POSITION LOSS", FailsafeAction.HOLD);
  static final Hazard ESTIMATOR =
      new Hazard("state estimator", "ON ESTIMATOR LOSS", FailsafeAction.HOLD);
  static final Hazard ACTUATOR_LINK =
      new Hazard("actuator link", "ON ACTUATOR LINK LOSS", FailsafeAction.HOLD);
  static final Hazard ACTUATION =
      new Hazard("actuation refused", "ON ACTUATION REFUSED", FailsafeAction.HOLD);
  static final Hazard HEALTH_MONITOR =
      new Hazard("health monitor", "ON HEALTH MONITOR LOSS", FailsafeAction.CONTINUE);
  static final Hazard SERVICE =
      new Hazard("service given up", "ON SERVICE LOSS", FailsafeAction.HOLD);
  static final Hazard LOW_BATTERY =
      new Hazard("low battery", "ON LOW BATTERY", FailsafeAction.RETURN);
  static final Hazard CRITICAL_BATTERY =
      new Hazard("critical battery", "ON CRITICAL BATTERY", FailsafeAction.RETURN);
  static final Hazard BATTERY_SENSOR =
      new Hazard("battery sensor", "ON BATTERY SENSOR LOSS", FailsafeAction.RETURN);
  static final Hazard RADIO = new Hazard("pilot's radio", "ON RADIO LOSS", FailsafeAction.CONTINUE);
  static final Hazard FENCE = new Hazard("geofence", "ON FENCE", FailsafeAction.RETURN);

  /** The hazards of every vehicle, in the order in which equally severe causes are reported. */
  static final List<Hazard> STANDARD =
      List.of(
          OPERATOR,
          OPERATOR_FOR_LONG,
          POSITION,
          ESTIMATOR,
          ACTUATOR_LINK,
          ACTUATION,
          HEALTH_MONITOR,
          SERVICE,
          LOW_BATTERY,
          CRITICAL_BATTERY,
          BATTERY_SENSOR,
          RADIO,
          FENCE);

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

  /** Name in causes. */
  String words() {
    return words;
  }

  /** Action according to the matrix. */
  FailsafeAction action(Configurator matrix) {
    return FailsafeAction.valueOf(matrix.getVariable(action));
  }

  String variable() {
    return action.name();
  }

  @Override
  public String toString() {
    return words;
  }
}
