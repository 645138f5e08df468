package org.u2sa.messages;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;

/**
 * Asks an actuator for a force, for those that announce one (thesis 3.2.3.9 foresees such
 * extensions).
 */
public class ForceCommand extends ActuatorCommand {
  private static final Schema<ForceCommand> SCHEMA =
      Schema.of(ForceCommand.class, ForceCommand::new, ActuatorCommand.TYPE).since(3);
  private static final NumberField<ForceCommand> FORCE =
      SCHEMA.requiredNumber("force", "N", Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);

  /** The schema. */
  public static final MessageType<ForceCommand> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends ForceCommand> type() {
    return TYPE;
  }

  /** Force along the announced direction [N]; the direction of positive percentages is positive. */
  public double force() {
    return require(FORCE);
  }

  /** Sets {@link #force()}. */
  public ForceCommand force(double value) {
    return put(FORCE, value);
  }

  /** A command that holds until the next. */
  public static ForceCommand of(String actuator, double forceN) {
    return new ForceCommand().actuatorName(actuator).force(forceN);
  }

  @Override
  public ForceCommand actuatorName(String name) {
    super.actuatorName(name);
    return this;
  }

  @Override
  public ForceCommand expiry(double seconds) {
    super.expiry(seconds);
    return this;
  }
}
