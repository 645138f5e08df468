package org.u2sa.messages.goal;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/**
 * A goal of the mission (thesis 3.2.3.3, figure 7); subclasses define what is to be reached and
 * when it counts as reached.
 */
public abstract class GoalInformation extends U2SAData {
  private static final Schema<GoalInformation> SCHEMA =
      Schema.ofAbstract(GoalInformation.class, UnknownGoal::new, U2SAData.TYPE);
  private static final ValueField<GoalInformation, String> UID = SCHEMA.requiredId("uid");
  private static final ValueField<GoalInformation, Boolean> COMPLETED = SCHEMA.flag("completed");
  private static final ValueField<GoalInformation, List<String>> NEXT = SCHEMA.ids("next");
  private static final ValueField<GoalInformation, String> DESCRIPTION =
      SCHEMA.optionalText("description");
  private static final ValueField<GoalInformation, Boolean> ABANDONED = SCHEMA.flag("abandoned");
  private static final ValueField<GoalInformation, GoalResult> RESULT =
      SCHEMA.since(3).optionalChoiceWithoutBit("result", GoalResult.class);
  private static final ValueField<GoalInformation, String> REASON = SCHEMA.optionalNote("reason");
  private static final ValueField<GoalInformation, Long> ARRIVED_AT =
      SCHEMA.optionalCount("arrivedAt", "µs");
  private static final NumberField<GoalInformation> TIME_LIMIT =
      SCHEMA.optionalNumberWithoutBit("timeLimit", "s", 0.0);
  private static final ValueField<GoalInformation, Long> CHOOSE =
      SCHEMA.optionalCount("choose", "");

  /**
   * UIDs of the goals that follow if it was completed, instead of next; an empty list ends the
   * mission.
   */
  private static final ValueField<GoalInformation, List<String>> NEXT_IF_DONE =
      SCHEMA.optionalIds("nextIfDone");

  /**
   * UIDs of the goals that follow if it was abandoned, instead of next; an empty list ends the
   * mission.
   */
  private static final ValueField<GoalInformation, List<String>> NEXT_IF_FAILED =
      SCHEMA.optionalIds("nextIfFailed");

  /**
   * UIDs of the goals that follow if it timed out, instead of next; an empty list ends the mission.
   */
  private static final ValueField<GoalInformation, List<String>> NEXT_IF_TIMED_OUT =
      SCHEMA.optionalIds("nextIfTimedOut");

  private static final ValueField<GoalInformation, String> REPEAT_FROM =
      SCHEMA.optionalId("repeatFrom");
  private static final ValueField<GoalInformation, Long> REPEAT_TIMES =
      SCHEMA.optionalCount("repeatTimes", "");

  static {
    SCHEMA.alias("name", UID); // the thesis's mission example, 3.2.3.2
  }

  public static final MessageType<GoalInformation> TYPE = SCHEMA.build();

  /** Identifier, unique within the mission: "1", "Takeoff". */
  public String uid() {
    return require(UID);
  }

  public GoalInformation uid(String uid) {
    return put(UID, uid);
  }

  /** True once the Path Planner has reached the goal. */
  public boolean completed() {
    return get(COMPLETED);
  }

  public GoalInformation completed(boolean completed) {
    return put(COMPLETED, completed);
  }

  /** UIDs of the goals that may follow this one; empty: the mission's order applies. */
  public List<String> next() {
    return get(NEXT);
  }

  public GoalInformation next(List<String> uids) {
    return put(NEXT, uids);
  }

  /** Description for the operator; empty if none. */
  public Optional<String> description() {
    return Optional.ofNullable(get(DESCRIPTION));
  }

  public GoalInformation description(String text) {
    return put(DESCRIPTION, text);
  }

  /** True once the Path Planner has abandoned the goal after its attempts. */
  public boolean abandoned() {
    return get(ABANDONED);
  }

  public GoalInformation abandoned(boolean abandoned) {
    return put(ABANDONED, abandoned);
  }

  /** Result; empty while the goal is open, and from senders that predate the field. */
  public Optional<GoalResult> result() {
    return Optional.ofNullable(get(RESULT));
  }

  public GoalInformation result(GoalResult value) {
    return put(RESULT, value);
  }

  /** Why it was abandoned, for people; empty if it was not, or if unknown. */
  public Optional<String> reason() {
    return Optional.ofNullable(get(REASON));
  }

  public GoalInformation reason(String text) {
    return put(REASON, text);
  }

  /** Time of arrival [µs of the run's clock]; empty before. */
  public OptionalLong arrivedAt() {
    return optionalCount(ARRIVED_AT);
  }

  public GoalInformation arrivedAt(long micros) {
    return put(ARRIVED_AT, micros);
  }

  /** Time limit for pursuing it [s]; empty: unlimited. */
  public OptionalDouble timeLimit() {
    return get(TIME_LIMIT);
  }

  public GoalInformation timeLimit(double seconds) {
    return put(TIME_LIMIT, seconds);
  }

  /**
   * Number of next goals that must be completed, regardless of which; empty: as configured in the
   * Mission Manager.
   */
  public OptionalLong choose() {
    return optionalCount(CHOOSE);
  }

  public GoalInformation choose(long goals) {
    return put(CHOOSE, goals);
  }

  /**
   * UIDs of the goals that follow only this result, instead of {@link #next()}; empty: no special
   * case.
   */
  public Optional<List<String>> nextIf(GoalResult result) {
    return Optional.ofNullable(nextField(result)).map(this::get);
  }

  /**
   * Sets {@link #nextIf}.
   *
   * @param result DONE, FAILED or TIMED_OUT
   * @param uids goals that follow; none ends the mission
   */
  public GoalInformation nextIf(GoalResult result, List<String> uids) {
    ValueField<GoalInformation, List<String>> field = nextField(result);
    if (field == null) {
      throw new IllegalArgumentException(
          "nextIf: " + result + " cannot have its own goals; expected DONE, FAILED or TIMED_OUT");
    }
    return put(field, List.copyOf(uids));
  }

  private static ValueField<GoalInformation, List<String>> nextField(GoalResult result) {
    return switch (result) {
      case DONE -> NEXT_IF_DONE;
      case FAILED -> NEXT_IF_FAILED;
      case TIMED_OUT -> NEXT_IF_TIMED_OUT;
      case SKIPPED -> null;
    };
  }

  /**
   * UID of the goal to which the mission jumps back {@link #repeatTimes()} times after this one
   * before it continues with {@link #next()}; empty: no repetition.
   */
  public Optional<String> repeatFrom() {
    return Optional.ofNullable(get(REPEAT_FROM));
  }

  public GoalInformation repeatFrom(String uid) {
    return put(REPEAT_FROM, uid);
  }

  /** Number of jumps back to {@link #repeatFrom()}; empty: one. */
  public OptionalLong repeatTimes() {
    return optionalCount(REPEAT_TIMES);
  }

  public GoalInformation repeatTimes(long times) {
    return put(REPEAT_TIMES, times);
  }

  @Override
  public GoalInformation copy() {
    return (GoalInformation) super.copy();
  }

  /** Placeholder for a goal of a class unknown to the reader. */
  private static final class UnknownGoal extends GoalInformation {
    @Override
    public MessageType<GoalInformation> type() {
      return TYPE;
    }
  }
}
