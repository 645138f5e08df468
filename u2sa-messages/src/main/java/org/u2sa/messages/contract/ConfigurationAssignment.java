package org.u2sa.messages.contract;

import java.util.Optional;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** A variable with its new value and, in results, its previous one. */
public final class ConfigurationAssignment extends U2SAData {
  private static final Schema<ConfigurationAssignment> SCHEMA =
      Schema.of(ConfigurationAssignment.class, ConfigurationAssignment::new, U2SAData.TYPE)
          .since(2);
  private static final ValueField<ConfigurationAssignment, String> VARIABLE_NAME =
      SCHEMA.requiredName("variableName");
  private static final ValueField<ConfigurationAssignment, String> VALUE =
      SCHEMA.requiredText("value");
  private static final ValueField<ConfigurationAssignment, String> PREVIOUS =
      SCHEMA.optionalText("previous");

  public static final MessageType<ConfigurationAssignment> TYPE = SCHEMA.build();

  @Override
  public MessageType<ConfigurationAssignment> type() {
    return TYPE;
  }

  /** Name of the variable. */
  public String variableName() {
    return require(VARIABLE_NAME);
  }

  public ConfigurationAssignment variableName(String value) {
    return put(VARIABLE_NAME, value);
  }

  /** The value as text, in the declared unit. */
  public String value() {
    return require(VALUE);
  }

  public ConfigurationAssignment value(String value) {
    return put(VALUE, value);
  }

  /** Previous value, in results. */
  public Optional<String> previous() {
    return Optional.ofNullable(get(PREVIOUS));
  }

  public ConfigurationAssignment previous(String value) {
    return put(PREVIOUS, value);
  }
}
