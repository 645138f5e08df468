package org.u2sa.messages.mission;

import java.util.Optional;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/**
 * Order to the Mission Manager to change the mission or its progress (thesis 3.2.3.2); it is
 * answered.
 */
public final class MissionOrder extends U2SAData {
  private static final Schema<MissionOrder> SCHEMA =
      Schema.of(MissionOrder.class, MissionOrder::new, U2SAData.TYPE).since(3);
  private static final ValueField<MissionOrder, String> REQUEST_ID = SCHEMA.requiredId("requestId");
  private static final ValueField<MissionOrder, MissionAction> ACTION =
      SCHEMA.requiredChoice("action", MissionAction.class);
  private static final ValueField<MissionOrder, String> UID = SCHEMA.optionalId("uid");
  private static final ValueField<MissionOrder, String> GOALS = SCHEMA.optionalText("goals");
  private static final ValueField<MissionOrder, String> FILE = SCHEMA.optionalText("file");
  private static final ValueField<MissionOrder, Boolean> NOW = SCHEMA.flag("now");
  private static final ValueField<MissionOrder, String> OPERATOR = SCHEMA.name("operator", "");

  public static final MessageType<MissionOrder> TYPE = SCHEMA.build();

  @Override
  public MessageType<MissionOrder> type() {
    return TYPE;
  }

  /** Unique ID, chosen by the sender, that the answer repeats. */
  public String requestId() {
    return require(REQUEST_ID);
  }

  public MissionOrder requestId(String value) {
    return put(REQUEST_ID, value);
  }

  /** Action to take. */
  public MissionAction action() {
    return require(ACTION);
  }

  public MissionOrder action(MissionAction value) {
    return put(ACTION, value);
  }

  /** UID of the goal to GOTO, to SKIP or to INSERT after; empty: the current one. */
  public Optional<String> uid() {
    return Optional.ofNullable(get(UID));
  }

  public MissionOrder uid(String value) {
    return put(UID, value);
  }

  /** Mission XML with the goals to INSERT, the fields to UPDATE, or the mission to REPLACE. */
  public Optional<String> goals() {
    return Optional.ofNullable(get(GOALS));
  }

  public MissionOrder goals(String value) {
    return put(GOALS, value);
  }

  /** File that {@link #goals()} was read from, for error messages. */
  public Optional<String> file() {
    return Optional.ofNullable(get(FILE));
  }

  public MissionOrder file(String value) {
    return put(FILE, value);
  }

  /** INSERT, REPLACE: whether to pursue the goals immediately. */
  public boolean now() {
    return require(NOW);
  }

  public MissionOrder now(boolean value) {
    return put(NOW, value);
  }

  /** Author of the order. */
  public String operator() {
    return require(OPERATOR);
  }

  public MissionOrder operator(String value) {
    return put(OPERATOR, value);
  }
}
