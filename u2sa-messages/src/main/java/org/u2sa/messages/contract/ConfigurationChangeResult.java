package org.u2sa.messages.contract;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** Result of a {@link ConfigurationChange}. */
public final class ConfigurationChangeResult extends ServiceMessage<ConfigurationChangeResult> {
  private static final Schema<ConfigurationChangeResult> SCHEMA =
      Schema.of(ConfigurationChangeResult.class, ConfigurationChangeResult::new, U2SAData.TYPE)
          .requiring(SERVICE_NAME);
  private static final ValueField<ConfigurationChangeResult, String> VARIABLE_NAME =
      SCHEMA.requiredName("variableName");
  private static final ValueField<ConfigurationChangeResult, Boolean> ACCEPTED =
      SCHEMA.flag("accepted");
  private static final ValueField<ConfigurationChangeResult, String> VALUE =
      SCHEMA.text("value", "");
  private static final ValueField<ConfigurationChangeResult, String> REASON = SCHEMA.note("reason");

  public static final MessageType<ConfigurationChangeResult> TYPE = SCHEMA.build();

  @Override
  public MessageType<ConfigurationChangeResult> type() {
    return TYPE;
  }

  /** Name of the variable. */
  public String variableName() {
    return require(VARIABLE_NAME);
  }

  public ConfigurationChangeResult variableName(String value) {
    return put(VARIABLE_NAME, value);
  }

  /** Whether the variable now has the new value. */
  public boolean accepted() {
    return require(ACCEPTED);
  }

  public ConfigurationChangeResult accepted(boolean value) {
    return put(ACCEPTED, value);
  }

  /** Current value as text. */
  public String value() {
    return require(VALUE);
  }

  public ConfigurationChangeResult value(String value) {
    return put(VALUE, value);
  }

  /** Why it was rejected, or that it is not saved; otherwise empty. */
  public String reason() {
    return require(REASON);
  }

  public ConfigurationChangeResult reason(String value) {
    return put(REASON, value);
  }
}
