package org.u2sa.messages.contract;

import java.util.List;
import java.util.OptionalLong;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** Request to a service to change several variables atomically: all or none (thesis 3.2.1.1). */
public final class ConfigurationTransaction extends ServiceExchange<ConfigurationTransaction> {
  private static final Schema<ConfigurationTransaction> SCHEMA =
      Schema.of(ConfigurationTransaction.class, ConfigurationTransaction::new, U2SAData.TYPE)
          .since(2)
          .requiringId(REQUEST_ID)
          .requiring(SERVICE_NAME);
  private static final ValueField<ConfigurationTransaction, List<ConfigurationAssignment>>
      ASSIGNMENTS = SCHEMA.messages("assignments", ConfigurationAssignment.TYPE);
  private static final ValueField<ConfigurationTransaction, String> AUTHOR =
      SCHEMA.name("author", "");
  private static final ValueField<ConfigurationTransaction, Long> REVISION =
      SCHEMA.optionalCount("revision", "");

  public static final MessageType<ConfigurationTransaction> TYPE = SCHEMA.build();

  @Override
  public MessageType<ConfigurationTransaction> type() {
    return TYPE;
  }

  /** The variables and their new values. */
  public List<ConfigurationAssignment> assignments() {
    return require(ASSIGNMENTS);
  }

  public ConfigurationTransaction assignments(List<ConfigurationAssignment> value) {
    return put(ASSIGNMENTS, List.copyOf(value));
  }

  /** Author of the change, for the audit log. */
  public String author() {
    return require(AUTHOR);
  }

  public ConfigurationTransaction author(String value) {
    return put(AUTHOR, value);
  }

  /**
   * Configuration revision on which the change is based; nothing is changed if it is outdated.
   * Empty: any revision.
   */
  public OptionalLong revision() {
    return optionalCount(REVISION);
  }

  public ConfigurationTransaction revision(long value) {
    return put(REVISION, value);
  }
}
