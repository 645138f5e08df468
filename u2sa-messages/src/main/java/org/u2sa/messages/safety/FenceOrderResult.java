package org.u2sa.messages.safety;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** Result of a {@link FenceOrder}. */
public final class FenceOrderResult extends U2SAData {
  private static final Schema<FenceOrderResult> SCHEMA =
      Schema.of(FenceOrderResult.class, FenceOrderResult::new, U2SAData.TYPE).since(3);
  private static final ValueField<FenceOrderResult, String> REQUEST_ID =
      SCHEMA.requiredId("requestId");
  private static final ValueField<FenceOrderResult, String> SERVICE_NAME =
      SCHEMA.requiredName("serviceName");
  private static final ValueField<FenceOrderResult, Boolean> ACCEPTED = SCHEMA.flag("accepted");
  private static final ValueField<FenceOrderResult, String> OUTCOME = SCHEMA.note("outcome");

  public static final MessageType<FenceOrderResult> TYPE = SCHEMA.build();

  @Override
  public MessageType<FenceOrderResult> type() {
    return TYPE;
  }

  /** ID of the order answered. */
  public String requestId() {
    return require(REQUEST_ID);
  }

  public FenceOrderResult requestId(String value) {
    return put(REQUEST_ID, value);
  }

  /** The service that answers. */
  public String serviceName() {
    return require(SERVICE_NAME);
  }

  public FenceOrderResult serviceName(String value) {
    return put(SERVICE_NAME, value);
  }

  /** Whether the order was executed. */
  public boolean accepted() {
    return require(ACCEPTED);
  }

  public FenceOrderResult accepted(boolean value) {
    return put(ACCEPTED, value);
  }

  /** What was done, or why the order was rejected. */
  public String outcome() {
    return require(OUTCOME);
  }

  public FenceOrderResult outcome(String value) {
    return put(OUTCOME, value);
  }
}
