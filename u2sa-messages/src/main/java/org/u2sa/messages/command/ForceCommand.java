package org.u2sa.messages.command;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;

/**
 * Commands a force, for actuators that announce one (an extension as foreseen by thesis 3.2.3.9).
 */
public class ForceCommand extends CommandSetters<ForceCommand> {
  private static final Schema<ForceCommand> SCHEMA =
      Schema.of(ForceCommand.class, ForceCommand::new, ActuatorCommand.TYPE).since(3);
  private static final NumberField<ForceCommand> FORCE =
      SCHEMA.requiredNumber("force", "N", Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);

  public static final MessageType<ForceCommand> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends ForceCommand> type() {
    return TYPE;
  }

  /** Force along the announced direction [N], with the sign of the percentage. */
  public double force() {
    return require(FORCE);
  }

  public ForceCommand force(double value) {
    return put(FORCE, value);
  }

  /** Creates a command valid until the next one. */
  public static ForceCommand of(String actuator, double forceN) {
    return new ForceCommand().actuatorName(actuator).force(forceN);
  }
}
