package org.u2sa.messages.command;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;

/**
 * Commands an actuator in percent of its range (thesis 3.2.3.9); whether that is a position or a
 * speed depends on the actuator.
 */
public class PercentageCommand extends CommandSetters<PercentageCommand> {
  private static final Schema<PercentageCommand> SCHEMA =
      Schema.of(PercentageCommand.class, PercentageCommand::new, ActuatorCommand.TYPE);
  private static final NumberField<PercentageCommand> PERCENTAGE =
      SCHEMA.requiredNumber("percentage", "%", -100.0, 100.0);

  public static final MessageType<PercentageCommand> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends PercentageCommand> type() {
    return TYPE;
  }

  /** Percentage of the actuator's range [%, -100…100]. */
  public double percentage() {
    return require(PERCENTAGE);
  }

  public PercentageCommand percentage(double value) {
    return put(PERCENTAGE, value);
  }

  /** Creates a command valid until the next one. */
  public static PercentageCommand of(String actuator, double percentage) {
    return new PercentageCommand().actuatorName(actuator).percentage(percentage);
  }
}
