package org.u2sa.messages.command;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;

/**
 * Commands an angle, for actuators that announce a fullAngle (an extension as foreseen by thesis
 * 3.2.3.9).
 */
public class AngleCommand extends CommandSetters<AngleCommand> {
  private static final Schema<AngleCommand> SCHEMA =
      Schema.of(AngleCommand.class, AngleCommand::new, ActuatorCommand.TYPE).since(3);
  private static final NumberField<AngleCommand> ANGLE =
      SCHEMA.requiredNumber("angle", "rad", Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);

  public static final MessageType<AngleCommand> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends AngleCommand> type() {
    return TYPE;
  }

  /** Angle from neutral [rad], with the sign of the percentage. */
  public double angle() {
    return require(ANGLE);
  }

  public AngleCommand angle(double value) {
    return put(ANGLE, value);
  }

  /** Creates a command valid until the next one. */
  public static AngleCommand of(String actuator, double angleRad) {
    return new AngleCommand().actuatorName(actuator).angle(angleRad);
  }
}
