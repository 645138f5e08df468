package org.u2sa.messages.mission;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** Result of a {@link MissionOrder}. */
public final class MissionOrderResult extends U2SAData {
  private static final Schema<MissionOrderResult> SCHEMA =
      Schema.of(MissionOrderResult.class, MissionOrderResult::new, U2SAData.TYPE).since(3);
  private static final ValueField<MissionOrderResult, String> REQUEST_ID =
      SCHEMA.requiredId("requestId");
  private static final ValueField<MissionOrderResult, String> SERVICE_NAME =
      SCHEMA.requiredName("serviceName");
  private static final ValueField<MissionOrderResult, Boolean> ACCEPTED = SCHEMA.flag("accepted");
  private static final ValueField<MissionOrderResult, String> OUTCOME = SCHEMA.note("outcome");

  public static final MessageType<MissionOrderResult> TYPE = SCHEMA.build();

  @Override
  public MessageType<MissionOrderResult> type() {
    return TYPE;
  }

  /** ID of the order answered. */
  public String requestId() {
    return require(REQUEST_ID);
  }

  public MissionOrderResult requestId(String value) {
    return put(REQUEST_ID, value);
  }

  /** The service that answers. */
  public String serviceName() {
    return require(SERVICE_NAME);
  }

  public MissionOrderResult serviceName(String value) {
    return put(SERVICE_NAME, value);
  }

  /** Whether the order was executed. */
  public boolean accepted() {
    return require(ACCEPTED);
  }

  public MissionOrderResult accepted(boolean value) {
    return put(ACCEPTED, value);
  }

  /** What was done, or why the order was rejected. */
  public String outcome() {
    return require(OUTCOME);
  }

  public MissionOrderResult outcome(String value) {
    return put(OUTCOME, value);
  }
}
