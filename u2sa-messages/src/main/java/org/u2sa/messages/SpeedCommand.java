package org.u2sa.messages;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;

/**
 * Turns an actuator at a speed, for those that announce a fullSpeed (thesis 3.2.3.9 foresees such
 * extensions).
 */
public class SpeedCommand extends ActuatorCommand {
  private static final Schema<SpeedCommand> SCHEMA =
      Schema.of(SpeedCommand.class, SpeedCommand::new, ActuatorCommand.TYPE).since(3);
  private static final NumberField<SpeedCommand> SPEED =
      SCHEMA.requiredNumber("speed", "rad/s", Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);

  /** The schema. */
  public static final MessageType<SpeedCommand> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends SpeedCommand> type() {
    return TYPE;
  }

  /** Speed of rotation [rad/s]; the direction of positive percentages is positive. */
  public double speed() {
    return require(SPEED);
  }

  /** Sets {@link #speed()}. */
  public SpeedCommand speed(double value) {
    return put(SPEED, value);
  }

  /** A command that holds until the next. */
  public static SpeedCommand of(String actuator, double speedRadPerS) {
    return new SpeedCommand().actuatorName(actuator).speed(speedRadPerS);
  }

  @Override
  public SpeedCommand actuatorName(String name) {
    super.actuatorName(name);
    return this;
  }

  @Override
  public SpeedCommand expiry(double seconds) {
    super.expiry(seconds);
    return this;
  }
}
