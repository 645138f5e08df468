package org.u2sa.messages.contract;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** What came of a {@link ServiceOrder}. */
public final class ServiceOrderResult extends U2SAData {
  private static final Schema<ServiceOrderResult> SCHEMA =
      Schema.of(ServiceOrderResult.class, ServiceOrderResult::new, U2SAData.TYPE).since(2);
  private static final ValueField<ServiceOrderResult, String> REQUEST_ID =
      SCHEMA.requiredText("requestId");
  private static final ValueField<ServiceOrderResult, String> SERVICE_NAME =
      SCHEMA.requiredText("serviceName");
  private static final ValueField<ServiceOrderResult, Boolean> ACCEPTED = SCHEMA.flag("accepted");
  private static final ValueField<ServiceOrderResult, String> REASON = SCHEMA.text("reason", "");

  /** The schema. */
  public static final MessageType<ServiceOrderResult> TYPE = SCHEMA.build();

  @Override
  public MessageType<ServiceOrderResult> type() {
    return TYPE;
  }

  /** The order that this answers. */
  public String requestId() {
    return require(REQUEST_ID);
  }

  /** Sets {@link #requestId()}. */
  public ServiceOrderResult requestId(String value) {
    return put(REQUEST_ID, value);
  }

  /** The service. */
  public String serviceName() {
    return require(SERVICE_NAME);
  }

  /** Sets {@link #serviceName()}. */
  public ServiceOrderResult serviceName(String value) {
    return put(SERVICE_NAME, value);
  }

  /** Whether it was done. */
  public boolean accepted() {
    return require(ACCEPTED);
  }

  /** Sets {@link #accepted()}. */
  public ServiceOrderResult accepted(boolean value) {
    return put(ACCEPTED, value);
  }

  /** Why not; empty if it was done. */
  public String reason() {
    return require(REASON);
  }

  /** Sets {@link #reason()}. */
  public ServiceOrderResult reason(String value) {
    return put(REASON, value);
  }
}
