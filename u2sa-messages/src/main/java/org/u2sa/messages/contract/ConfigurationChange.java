package org.u2sa.messages.contract;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** Request to a service to change a variable (thesis 3.2.1.1). */
public final class ConfigurationChange extends ServiceMessage<ConfigurationChange> {
  private static final Schema<ConfigurationChange> SCHEMA =
      Schema.of(ConfigurationChange.class, ConfigurationChange::new, U2SAData.TYPE)
          .requiring(SERVICE_NAME);
  private static final ValueField<ConfigurationChange, String> VARIABLE_NAME =
      SCHEMA.requiredName("variableName");
  private static final ValueField<ConfigurationChange, String> VALUE = SCHEMA.requiredText("value");

  public static final MessageType<ConfigurationChange> TYPE = SCHEMA.build();

  @Override
  public MessageType<ConfigurationChange> type() {
    return TYPE;
  }

  /** Name of the variable. */
  public String variableName() {
    return require(VARIABLE_NAME);
  }

  public ConfigurationChange variableName(String value) {
    return put(VARIABLE_NAME, value);
  }

  /** The new value as text. */
  public String value() {
    return require(VALUE);
  }

  public ConfigurationChange value(String value) {
    return put(VALUE, value);
  }
}
