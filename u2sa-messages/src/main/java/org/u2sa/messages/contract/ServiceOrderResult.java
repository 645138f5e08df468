package org.u2sa.messages.contract;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** Result of a {@link ServiceOrder}. */
public final class ServiceOrderResult extends ServiceExchange<ServiceOrderResult> {
  private static final Schema<ServiceOrderResult> SCHEMA =
      Schema.of(ServiceOrderResult.class, ServiceOrderResult::new, U2SAData.TYPE)
          .since(2)
          .requiringId(REQUEST_ID)
          .requiring(SERVICE_NAME);
  private static final ValueField<ServiceOrderResult, Boolean> ACCEPTED = SCHEMA.flag("accepted");
  private static final ValueField<ServiceOrderResult, String> REASON = SCHEMA.note("reason");

  public static final MessageType<ServiceOrderResult> TYPE = SCHEMA.build();

  @Override
  public MessageType<ServiceOrderResult> type() {
    return TYPE;
  }

  /** Whether the order was executed. */
  public boolean accepted() {
    return require(ACCEPTED);
  }

  public ServiceOrderResult accepted(boolean value) {
    return put(ACCEPTED, value);
  }

  /** Why it was rejected; empty if executed. */
  public String reason() {
    return require(REASON);
  }

  public ServiceOrderResult reason(String value) {
    return put(REASON, value);
  }
}
