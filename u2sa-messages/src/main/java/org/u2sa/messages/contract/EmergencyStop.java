package org.u2sa.messages.contract;

import java.util.OptionalLong;
import org.u2sa.messages.MessageType;
import org.u2sa.messages.Schema;
import org.u2sa.messages.U2SAData;
import org.u2sa.messages.ValueField;

/**
 * Stops everything that moves at once, and keeps it stopped until an operator clears it. Retained,
 * so that an actuator that comes late obeys too. A message with {@code active} latches; one without
 * lifts the stops that it names by {@code clears}, and no newer one.
 */
public final class EmergencyStop extends U2SAData {
  private static final int FORMAT = 2; // joined the wire format with it
  private static final Schema<EmergencyStop> SCHEMA =
      Schema.of("EmergencyStop", EmergencyStop.class, EmergencyStop::new, U2SAData.TYPE)
          .since(FORMAT);
  private static final ValueField<EmergencyStop, Boolean> ACTIVE = SCHEMA.flag("active");
  private static final ValueField<EmergencyStop, String> OPERATOR = SCHEMA.text("operator", "");
  private static final ValueField<EmergencyStop, String> REASON = SCHEMA.text("reason", "");
  private static final ValueField<EmergencyStop, Long> CLEARS =
      SCHEMA.optionalCount("clears", "us");

  /** The schema. */
  public static final MessageType<EmergencyStop> TYPE = SCHEMA.build();

  @Override
  public MessageType<EmergencyStop> type() {
    return TYPE;
  }

  /**
   * True: everything that moves goes neutral and stays so. False: the stops up to {@link #clears()}
   * are lifted.
   */
  public boolean active() {
    return require(ACTIVE);
  }

  /** Sets {@link #active()}. */
  public EmergencyStop active(boolean value) {
    put(ACTIVE, value);
    return this;
  }

  /** Who stopped or cleared; empty if unknown. */
  public String operator() {
    return require(OPERATOR);
  }

  /** Sets {@link #operator()}. */
  public EmergencyStop operator(String value) {
    put(OPERATOR, value);
    return this;
  }

  /** Why, in words. */
  public String reason() {
    return require(REASON);
  }

  /** Sets {@link #reason()}. */
  public EmergencyStop reason(String value) {
    put(REASON, value);
    return this;
  }

  /** The timestamp of the newest stop that this message lifts [µs]; empty in a stop. */
  public OptionalLong clears() {
    Long value = get(CLEARS);
    return value == null ? OptionalLong.empty() : OptionalLong.of(value);
  }

  /** Sets {@link #clears()}. */
  public EmergencyStop clears(long value) {
    put(CLEARS, value);
    return this;
  }
}
