package org.u2sa.messages.command;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;

/**
 * Commands a rotational speed, for actuators that announce a fullSpeed (an extension as foreseen by
 * thesis 3.2.3.9).
 */
public class SpeedCommand extends CommandSetters<SpeedCommand> {
  private static final Schema<SpeedCommand> SCHEMA =
      Schema.of(SpeedCommand.class, SpeedCommand::new, ActuatorCommand.TYPE).since(3);
  private static final NumberField<SpeedCommand> SPEED =
      SCHEMA.requiredNumber("speed", "rad/s", Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);

  public static final MessageType<SpeedCommand> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends SpeedCommand> type() {
    return TYPE;
  }

  /** Rotational speed [rad/s], with the sign of the percentage. */
  public double speed() {
    return require(SPEED);
  }

  public SpeedCommand speed(double value) {
    return put(SPEED, value);
  }

  /** Creates a command valid until the next one. */
  public static SpeedCommand of(String actuator, double speedRadPerS) {
    return new SpeedCommand().actuatorName(actuator).speed(speedRadPerS);
  }
}
