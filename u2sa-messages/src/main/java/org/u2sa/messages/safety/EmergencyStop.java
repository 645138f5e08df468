package org.u2sa.messages.safety;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/**
 * Stops everything that moves immediately, and keeps it stopped until an operator clears it.
 * Retained, so that actuators that connect later also obey it. A message with {@code active}
 * latches; one without clears the stops listed in {@code lifts}, or if none are listed, all up to
 * {@code clears}.
 */
public final class EmergencyStop extends U2SAData {
  private static final Schema<EmergencyStop> SCHEMA =
      Schema.of(EmergencyStop.class, EmergencyStop::new, U2SAData.TYPE).since(2);
  private static final ValueField<EmergencyStop, Boolean> ACTIVE = SCHEMA.flag("active");
  private static final ValueField<EmergencyStop, String> OPERATOR = SCHEMA.note("operator");
  private static final ValueField<EmergencyStop, String> REASON = SCHEMA.note("reason");
  private static final ValueField<EmergencyStop, Long> CLEARS =
      SCHEMA.optionalCount("clears", "us");
  private static final ValueField<EmergencyStop, String> STOP_ID =
      SCHEMA.since(3).optionalId("stopId");
  private static final ValueField<EmergencyStop, List<String>> LIFTS =
      SCHEMA.optionalTexts("lifts");

  public static final MessageType<EmergencyStop> TYPE = SCHEMA.build();

  @Override
  public MessageType<EmergencyStop> type() {
    return TYPE;
  }

  /**
   * True: everything that moves goes neutral and stays so. False: clears the stops listed in {@link
   * #lifts()}, or if none are listed, all up to {@link #clears()}.
   */
  public boolean active() {
    return require(ACTIVE);
  }

  public EmergencyStop active(boolean value) {
    return put(ACTIVE, value);
  }

  /** Operator or service that stopped or cleared; empty if unknown. */
  public String operator() {
    return require(OPERATOR);
  }

  public EmergencyStop operator(String value) {
    return put(OPERATOR, value);
  }

  /** Reason, in words. */
  public String reason() {
    return require(REASON);
  }

  public EmergencyStop reason(String value) {
    return put(REASON, value);
  }

  /** Timestamp of the newest stop that this message clears [µs]; empty in a stop. */
  public OptionalLong clears() {
    return optionalCount(CLEARS);
  }

  public EmergencyStop clears(long value) {
    return put(CLEARS, value);
  }

  /**
   * Unique ID of this stop in the system; repetitions keep it. Empty in a clear, and from senders
   * that predate the field.
   */
  public Optional<String> stopId() {
    return Optional.ofNullable(get(STOP_ID));
  }

  public EmergencyStop stopId(String value) {
    return put(STOP_ID, value);
  }

  /** Stops that this message clears, by {@link #identity()}; empty: all up to {@link #clears()}. */
  public List<String> lifts() {
    List<String> value = get(LIFTS);
    return value == null ? List.of() : value;
  }

  public EmergencyStop lifts(List<String> value) {
    return put(LIFTS, List.copyOf(value));
  }

  /**
   * Identifies this stop: its {@link #stopId()}, or if the sender gave none, its operator, time and
   * reason.
   */
  public String identity() {
    return stopId()
        .orElseGet(
            () -> systemId() + "|" + timestamp().orElse(-1L) + "|" + operator() + "|" + reason());
  }
}
