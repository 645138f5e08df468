package org.u2sa.messages.safety;

import java.util.OptionalDouble;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** Heartbeat of a supervising operator; when it ceases, the operator's link counts as lost. */
public final class OperatorHeartbeat extends U2SAData {
  private static final Schema<OperatorHeartbeat> SCHEMA =
      Schema.of(OperatorHeartbeat.class, OperatorHeartbeat::new, U2SAData.TYPE).since(2);
  private static final ValueField<OperatorHeartbeat, String> OPERATOR =
      SCHEMA.requiredName("operator");
  private static final NumberField<OperatorHeartbeat> INTERVAL =
      SCHEMA.optionalNumber("interval", "s", 0.0);

  public static final MessageType<OperatorHeartbeat> TYPE = SCHEMA.build();

  @Override
  public MessageType<OperatorHeartbeat> type() {
    return TYPE;
  }

  /** Name of the operator. */
  public String operator() {
    return require(OPERATOR);
  }

  public OperatorHeartbeat operator(String value) {
    return put(OPERATOR, value);
  }

  /** Heartbeat period [s]. */
  public OptionalDouble interval() {
    return get(INTERVAL);
  }

  public OperatorHeartbeat interval(double value) {
    return put(INTERVAL, value);
  }
}
