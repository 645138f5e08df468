package org.u2sa.messages.goal;

import java.util.List;
import java.util.OptionalDouble;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;

/**
 * A payload drop onto a position whose ground is at altitude {@link #z}; reached when the payload
 * has been released at a point from which it falls within the {@link #horizontalThreshold}, given
 * the wind.
 */
public class PayloadDrop extends Waypoint {
  private static final Schema<PayloadDrop> SCHEMA =
      Schema.of(PayloadDrop.class, PayloadDrop::new, Waypoint.TYPE).since(3);
  private static final ValueField<PayloadDrop, String> PAYLOAD = SCHEMA.name("payload", "RELEASE");
  private static final NumberField<PayloadDrop> HEIGHT = SCHEMA.optionalNumber("height", "m", 0.0);
  private static final NumberField<PayloadDrop> TERMINAL_SPEED =
      SCHEMA.optionalNumber("terminalSpeed", "m/s", 0.1);

  public static final MessageType<PayloadDrop> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends PayloadDrop> type() {
    return TYPE;
  }

  /** Subsystem that releases it; defaults to "RELEASE". */
  public String payload() {
    return get(PAYLOAD);
  }

  public PayloadDrop payload(String value) {
    return put(PAYLOAD, value);
  }

  /** Height above the position from which to drop [m]; empty: the vehicle keeps its altitude. */
  public OptionalDouble height() {
    return get(HEIGHT);
  }

  public PayloadDrop height(double metres) {
    return put(HEIGHT, metres);
  }

  /** Terminal speed of the payload [m/s]; empty: falls without drag. */
  public OptionalDouble terminalSpeed() {
    return get(TERMINAL_SPEED);
  }

  public PayloadDrop terminalSpeed(double metresPerSecond) {
    return put(TERMINAL_SPEED, metresPerSecond);
  }

  @Override
  public PayloadDrop uid(String uid) {
    return (PayloadDrop) super.uid(uid);
  }

  @Override
  public PayloadDrop next(List<String> uids) {
    return (PayloadDrop) super.next(uids);
  }
}
