package org.u2sa.messages.contract;

import java.util.List;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** Result of a {@link ConfigurationTransaction} or {@link ConfigurationUndo}. */
public final class ConfigurationTransactionResult
    extends ServiceExchange<ConfigurationTransactionResult> {
  private static final Schema<ConfigurationTransactionResult> SCHEMA =
      Schema.of(
              ConfigurationTransactionResult.class,
              ConfigurationTransactionResult::new,
              U2SAData.TYPE)
          .since(2)
          .requiringId(REQUEST_ID)
          .requiring(SERVICE_NAME);
  private static final ValueField<ConfigurationTransactionResult, Boolean> ACCEPTED =
      SCHEMA.flag("accepted");
  private static final ValueField<ConfigurationTransactionResult, String> REASON =
      SCHEMA.note("reason");
  private static final ValueField<ConfigurationTransactionResult, List<ConfigurationAssignment>>
      ASSIGNMENTS = SCHEMA.messages("assignments", ConfigurationAssignment.TYPE);
  private static final ValueField<ConfigurationTransactionResult, Long> REVISION =
      SCHEMA.count("revision", "");
  private static final ValueField<ConfigurationTransactionResult, String> AUTHOR =
      SCHEMA.name("author", "");

  public static final MessageType<ConfigurationTransactionResult> TYPE = SCHEMA.build();

  @Override
  public MessageType<ConfigurationTransactionResult> type() {
    return TYPE;
  }

  /** Whether all variables now have their new values. */
  public boolean accepted() {
    return require(ACCEPTED);
  }

  public ConfigurationTransactionResult accepted(boolean value) {
    return put(ACCEPTED, value);
  }

  /** Why it was rejected, or that it is not saved; otherwise empty. */
  public String reason() {
    return require(REASON);
  }

  public ConfigurationTransactionResult reason(String value) {
    return put(REASON, value);
  }

  /** The variables with their new and previous values; the requested ones if rejected. */
  public List<ConfigurationAssignment> assignments() {
    return require(ASSIGNMENTS);
  }

  public ConfigurationTransactionResult assignments(List<ConfigurationAssignment> value) {
    return put(ASSIGNMENTS, List.copyOf(value));
  }

  /** Current configuration revision. */
  public long revision() {
    return require(REVISION);
  }

  public ConfigurationTransactionResult revision(long value) {
    return put(REVISION, value);
  }

  /** Author of the request. */
  public String author() {
    return require(AUTHOR);
  }

  public ConfigurationTransactionResult author(String value) {
    return put(AUTHOR, value);
  }
}
