package org.u2sa.service.actuator;

import java.util.List;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.messages.command.ActuatorCommand;
import org.u2sa.messages.command.AngleCommand;
import org.u2sa.messages.command.ForceCommand;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.command.SpeedCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;

/**
 * Command types and ranges an actuator announced, and their conversion to percent.
 *
 * @param range [%]
 * @param types other than percentages
 * @param fullAngle [rad]; NaN: none
 * @param fullSpeed [rad/s]; NaN: none
 */
record ActuatorExtents(
    Range range, List<String> types, double fullAngle, double fullSpeed, EffectCurve curve) {
  private static final double FULL_PERCENT = 100.0;

  static ActuatorExtents ofPercentages(Range range) {
    return new ActuatorExtents(range, List.of(), Double.NaN, Double.NaN, EffectCurve.LINEAR);
  }

  static ActuatorExtents of(ActuatorAnnouncement announced) {
    return new ActuatorExtents(
        Range.of(announced.minimum(), announced.maximum()),
        announced.commandTypes(),
        announced.fullAngle().orElse(Double.NaN),
        announced.fullSpeed().orElse(Double.NaN),
        EffectCurve.of(announced));
  }

  boolean takesOnlyPercentages() {
    return types.isEmpty();
  }

  boolean takes(ActuatorCommand command) {
    return command instanceof PercentageCommand
        || command.typeChain().stream().anyMatch(types::contains) && !isUnknown(command);
  }

  private static boolean isUnknown(ActuatorCommand command) {
    return !(command instanceof AngleCommand
        || command instanceof SpeedCommand
        || command instanceof ForceCommand);
  }

  /** Converts an accepted command to percent; NaN if it is not a number or has no scale. */
  double percentage(ActuatorCommand command) {
    if (command instanceof PercentageCommand percentage) {
      return percentage.percentage();
    }
    if (command instanceof AngleCommand angle) {
      return FULL_PERCENT * angle.angle() / fullAngle;
    }
    if (command instanceof SpeedCommand speed) {
      return FULL_PERCENT * speed.speed() / fullSpeed;
    }
    return command instanceof ForceCommand force ? curve.percentOfForce(force.force()) : Double.NaN;
  }

  boolean contains(double percentage) {
    return range.contains(percentage);
  }
}
