package org.u2sa.messages.contract;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** Request to a service to undo its last configuration change. */
public final class ConfigurationUndo extends ServiceExchange<ConfigurationUndo> {
  private static final Schema<ConfigurationUndo> SCHEMA =
      Schema.of(ConfigurationUndo.class, ConfigurationUndo::new, U2SAData.TYPE)
          .since(2)
          .requiringId(REQUEST_ID)
          .requiring(SERVICE_NAME);
  private static final ValueField<ConfigurationUndo, String> AUTHOR = SCHEMA.name("author", "");

  public static final MessageType<ConfigurationUndo> TYPE = SCHEMA.build();

  @Override
  public MessageType<ConfigurationUndo> type() {
    return TYPE;
  }

  /** Author of the undo, for the audit log. */
  public String author() {
    return require(AUTHOR);
  }

  public ConfigurationUndo author(String value) {
    return put(AUTHOR, value);
  }
}
