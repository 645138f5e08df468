package org.u2sa.messages.contract;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** Tells a service to take its last configuration change back. */
public final class ConfigurationUndo extends U2SAData {
  private static final Schema<ConfigurationUndo> SCHEMA =
      Schema.of(ConfigurationUndo.class, ConfigurationUndo::new, U2SAData.TYPE).since(2);
  private static final ValueField<ConfigurationUndo, String> REQUEST_ID =
      SCHEMA.requiredText("requestId");
  private static final ValueField<ConfigurationUndo, String> SERVICE_NAME =
      SCHEMA.requiredText("serviceName");
  private static final ValueField<ConfigurationUndo, String> AUTHOR = SCHEMA.text("author", "");

  /** The schema. */
  public static final MessageType<ConfigurationUndo> TYPE = SCHEMA.build();

  @Override
  public MessageType<ConfigurationUndo> type() {
    return TYPE;
  }

  /** What the answer is recognised by; chosen by the sender, unique. */
  public String requestId() {
    return require(REQUEST_ID);
  }

  /** Sets {@link #requestId()}. */
  public ConfigurationUndo requestId(String value) {
    return put(REQUEST_ID, value);
  }

  /** The service. */
  public String serviceName() {
    return require(SERVICE_NAME);
  }

  /** Sets {@link #serviceName()}. */
  public ConfigurationUndo serviceName(String value) {
    return put(SERVICE_NAME, value);
  }

  /** Who takes it back, for the audit log. */
  public String author() {
    return require(AUTHOR);
  }

  /** Sets {@link #author()}. */
  public ConfigurationUndo author(String value) {
    return put(AUTHOR, value);
  }
}
