package org.u2sa.messages.command;

import java.util.OptionalDouble;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** Command to one actuator (thesis 3.2.3.9, figure 13); subclasses define the quantity. */
public class ActuatorCommand extends U2SAData {
  private static final Schema<ActuatorCommand> SCHEMA =
      Schema.of(ActuatorCommand.class, ActuatorCommand::new, U2SAData.TYPE);
  private static final ValueField<ActuatorCommand, String> ACTUATOR_NAME =
      SCHEMA.requiredName("actuatorName");
  private static final NumberField<ActuatorCommand> EXPIRY =
      SCHEMA.optionalNumber("expiry", "s", 0.0);

  public static final MessageType<ActuatorCommand> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends ActuatorCommand> type() {
    return TYPE;
  }

  /** Name of the addressed actuator. */
  public String actuatorName() {
    return require(ACTUATOR_NAME);
  }

  public ActuatorCommand actuatorName(String value) {
    return put(ACTUATOR_NAME, value);
  }

  /** Validity of the command, counted from its timestamp [s]; empty: until the next command. */
  public OptionalDouble expiry() {
    return get(EXPIRY);
  }

  public ActuatorCommand expiry(double value) {
    return put(EXPIRY, value);
  }
}
