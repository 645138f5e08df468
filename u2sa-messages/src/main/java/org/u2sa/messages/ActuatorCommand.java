package org.u2sa.messages;

import java.util.OptionalDouble;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** What one actuator is to do (thesis 3.2.3.9, figure 13); a subclass says what. */
public class ActuatorCommand extends U2SAData {
  private static final Schema<ActuatorCommand> SCHEMA =
      Schema.of(ActuatorCommand.class, ActuatorCommand::new, U2SAData.TYPE);
  private static final ValueField<ActuatorCommand, String> ACTUATOR_NAME =
      SCHEMA.requiredName("actuatorName");
  private static final NumberField<ActuatorCommand> EXPIRY =
      SCHEMA.optionalNumber("expiry", "s", 0.0);

  /** The schema. */
  public static final MessageType<ActuatorCommand> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends ActuatorCommand> type() {
    return TYPE;
  }

  /** The actuator that is to obey. */
  public String actuatorName() {
    return require(ACTUATOR_NAME);
  }

  /** Sets {@link #actuatorName()}. */
  public ActuatorCommand actuatorName(String value) {
    return put(ACTUATOR_NAME, value);
  }

  /** How long the command holds from its timestamp [s]; empty: until the next. */
  public OptionalDouble expiry() {
    return get(EXPIRY);
  }

  /** Sets {@link #expiry()}. */
  public ActuatorCommand expiry(double value) {
    return put(EXPIRY, value);
  }
}
