package org.u2sa.messages.contract;

import java.util.Optional;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/**
 * Tells the Mission Manager to change the mission or its course (thesis 3.2.3.2), and wants an
 * answer.
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

  /** The schema. */
  public static final MessageType<MissionOrder> TYPE = SCHEMA.build();

  @Override
  public MessageType<MissionOrder> type() {
    return TYPE;
  }

  /** What the answer is recognised by; chosen by the sender, unique. */
  public String requestId() {
    return require(REQUEST_ID);
  }

  /** Sets {@link #requestId()}. */
  public MissionOrder requestId(String value) {
    return put(REQUEST_ID, value);
  }

  /** What to do. */
  public MissionAction action() {
    return require(ACTION);
  }

  /** Sets {@link #action()}. */
  public MissionOrder action(MissionAction value) {
    return put(ACTION, value);
  }

  /** The goal: GOTO which, SKIP which, INSERT after which; empty: the current one. */
  public Optional<String> uid() {
    return Optional.ofNullable(get(UID));
  }

  /** Sets {@link #uid()}. */
  public MissionOrder uid(String value) {
    return put(UID, value);
  }

  /** A mission in XML, whose goals INSERT adds and UPDATE takes the fields of. */
  public Optional<String> goals() {
    return Optional.ofNullable(get(GOALS));
  }

  /** Sets {@link #goals()}. */
  public MissionOrder goals(String value) {
    return put(GOALS, value);
  }

  /** The file that {@link #goals()} was read from, for errors. */
  public Optional<String> file() {
    return Optional.ofNullable(get(FILE));
  }

  /** Sets {@link #file()}. */
  public MissionOrder file(String value) {
    return put(FILE, value);
  }

  /** INSERT: whether the goals are pursued at once, and what is current now after them. */
  public boolean now() {
    return require(NOW);
  }

  /** Sets {@link #now()}. */
  public MissionOrder now(boolean value) {
    return put(NOW, value);
  }

  /** Who orders it. */
  public String operator() {
    return require(OPERATOR);
  }

  /** Sets {@link #operator()}. */
  public MissionOrder operator(String value) {
    return put(OPERATOR, value);
  }
}
