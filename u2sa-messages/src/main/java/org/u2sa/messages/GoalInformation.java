package org.u2sa.messages;

import java.util.List;
import java.util.Optional;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/**
 * A goal of the mission (thesis 3.2.3.3, figure 7): a subclass says what is to be reached and when
 * it is.
 */
public abstract class GoalInformation extends U2SAData {
  private static final Schema<GoalInformation> SCHEMA =
      Schema.ofAbstract(GoalInformation.class, UnknownGoal::new, U2SAData.TYPE);
  private static final ValueField<GoalInformation, String> UID = SCHEMA.requiredText("uid");
  private static final ValueField<GoalInformation, Boolean> COMPLETED = SCHEMA.flag("completed");
  private static final ValueField<GoalInformation, List<String>> NEXT = SCHEMA.texts("next");
  private static final ValueField<GoalInformation, String> DESCRIPTION =
      SCHEMA.optionalText("description");
  private static final ValueField<GoalInformation, Boolean> ABANDONED = SCHEMA.flag("abandoned");

  static {
    SCHEMA.alias("name", UID); // the thesis's mission example, 3.2.3.2
  }

  /** The schema. */
  public static final MessageType<GoalInformation> TYPE = SCHEMA.build();

  /** Unique among the goals of a mission: "1", "Takeoff". */
  public String uid() {
    return require(UID);
  }

  /** Sets {@link #uid()}. */
  public GoalInformation uid(String uid) {
    return put(UID, uid);
  }

  /** True once the Path Planner found the goal reached. */
  public boolean completed() {
    return get(COMPLETED);
  }

  /** Sets {@link #completed()}. */
  public GoalInformation completed(boolean completed) {
    return put(COMPLETED, completed);
  }

  /** UIDs of the goals that may come after this one; empty: whatever the mission's order says. */
  public List<String> next() {
    return get(NEXT);
  }

  /** Sets {@link #next()}. */
  public GoalInformation next(List<String> uids) {
    return put(NEXT, uids);
  }

  /** What an operator reads; empty if there is none. */
  public Optional<String> description() {
    return Optional.ofNullable(get(DESCRIPTION));
  }

  /** Sets {@link #description()}. */
  public GoalInformation description(String text) {
    return put(DESCRIPTION, text);
  }

  /**
   * True once the Path Planner gave the goal up after its attempts: never completed, left behind.
   */
  public boolean abandoned() {
    return get(ABANDONED);
  }

  /** Sets {@link #abandoned()}. */
  public GoalInformation abandoned(boolean abandoned) {
    return put(ABANDONED, abandoned);
  }

  @Override
  public GoalInformation copy() {
    return (GoalInformation) super.copy();
  }

  /** Stands for a goal of a class that the reader does not know. */
  private static final class UnknownGoal extends GoalInformation {
    @Override
    public MessageType<GoalInformation> type() {
      return TYPE;
    }
  }
}
