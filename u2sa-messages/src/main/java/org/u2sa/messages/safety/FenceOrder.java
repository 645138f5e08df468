package org.u2sa.messages.safety;

import java.util.Optional;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** Order to the Safety Manager to change the fence in force; answered by a result. */
public final class FenceOrder extends U2SAData {
  private static final Schema<FenceOrder> SCHEMA =
      Schema.of(FenceOrder.class, FenceOrder::new, U2SAData.TYPE).since(3);
  private static final ValueField<FenceOrder, String> REQUEST_ID = SCHEMA.requiredId("requestId");
  private static final ValueField<FenceOrder, FenceAction> ACTION =
      SCHEMA.requiredChoice("action", FenceAction.class);
  private static final ValueField<FenceOrder, String> FENCE = SCHEMA.optionalText("fence");
  private static final ValueField<FenceOrder, String> FILE = SCHEMA.optionalText("file");
  private static final ValueField<FenceOrder, String> OPERATOR = SCHEMA.name("operator", "");

  public static final MessageType<FenceOrder> TYPE = SCHEMA.build();

  @Override
  public MessageType<FenceOrder> type() {
    return TYPE;
  }

  /** Unique ID, chosen by the sender, that the answer repeats. */
  public String requestId() {
    return require(REQUEST_ID);
  }

  public FenceOrder requestId(String value) {
    return put(REQUEST_ID, value);
  }

  /** Action to take. */
  public FenceAction action() {
    return require(ACTION);
  }

  public FenceOrder action(FenceAction value) {
    return put(ACTION, value);
  }

  /** REPLACE: fence XML, as in a file of the Safety Manager's variable FENCE. */
  public Optional<String> fence() {
    return Optional.ofNullable(get(FENCE));
  }

  public FenceOrder fence(String value) {
    return put(FENCE, value);
  }

  /** File that {@link #fence()} was read from, for error messages. */
  public Optional<String> file() {
    return Optional.ofNullable(get(FILE));
  }

  public FenceOrder file(String value) {
    return put(FILE, value);
  }

  /** Author of the order. */
  public String operator() {
    return require(OPERATOR);
  }

  public FenceOrder operator(String value) {
    return put(OPERATOR, value);
  }
}
