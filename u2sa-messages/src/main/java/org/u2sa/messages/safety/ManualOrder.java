package org.u2sa.messages.safety;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** Request to begin or end driving by hand; answered by a {@link ManualState}. */
public final class ManualOrder extends U2SAData {
  private static final Schema<ManualOrder> SCHEMA =
      Schema.of(ManualOrder.class, ManualOrder::new, U2SAData.TYPE).since(3);
  private static final ValueField<ManualOrder, String> REQUEST_ID = SCHEMA.requiredId("requestId");
  private static final ValueField<ManualOrder, Boolean> ACTIVE = SCHEMA.flag("active");
  private static final ValueField<ManualOrder, String> OPERATOR = SCHEMA.name("operator", "");

  public static final MessageType<ManualOrder> TYPE = SCHEMA.build();

  @Override
  public MessageType<ManualOrder> type() {
    return TYPE;
  }

  /** Unique ID, chosen by the sender, that the answer repeats. */
  public String requestId() {
    return require(REQUEST_ID);
  }

  public ManualOrder requestId(String value) {
    return put(REQUEST_ID, value);
  }

  /**
   * True: navigation is ignored, and {@link ManualDrive} obeyed. False: navigation is obeyed again.
   */
  public boolean active() {
    return require(ACTIVE);
  }

  public ManualOrder active(boolean value) {
    return put(ACTIVE, value);
  }

  /** Name of the requester, who then drives. */
  public String operator() {
    return require(OPERATOR);
  }

  public ManualOrder operator(String value) {
    return put(OPERATOR, value);
  }
}
