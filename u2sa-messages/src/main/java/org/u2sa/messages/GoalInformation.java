package org.u2sa.messages;

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
 * A goal of the mission (thesis 3.2.3.3, figure 7): a subclass says what is to be reached and when
 * it is.
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
   * UIDs of the goals that follow once it is done, in place of next; an empty list ends the
   * mission.
   */
  private static final ValueField<GoalInformation, List<String>> NEXT_IF_DONE =
      SCHEMA.optionalIds("nextIfDone");

  /**
   * UIDs of the goals that follow if it was given up, in place of next; an empty list ends the
   * mission.
   */
  private static final ValueField<GoalInformation, List<String>> NEXT_IF_FAILED =
      SCHEMA.optionalIds("nextIfFailed");

  /**
   * UIDs of the goals that follow if its time ran out, in place of next; an empty list ends the
   * mission.
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

  /** What came of it; empty while nothing has, and from senders that do not know the field. */
  public Optional<GoalResult> result() {
    return Optional.ofNullable(get(RESULT));
  }

  /** Sets {@link #result()}. */
  public GoalInformation result(GoalResult value) {
    return put(RESULT, value);
  }

  /** Why it was given up, for people; empty if it was not, or if nobody said. */
  public Optional<String> reason() {
    return Optional.ofNullable(get(REASON));
  }

  /** Sets {@link #reason()}. */
  public GoalInformation reason(String text) {
    return put(REASON, text);
  }

  /** When the vehicle arrived [µs of the run's clock]; empty until it has. */
  public OptionalLong arrivedAt() {
    return optionalCount(ARRIVED_AT);
  }

  /** Sets {@link #arrivedAt()}. */
  public GoalInformation arrivedAt(long micros) {
    return put(ARRIVED_AT, micros);
  }

  /** How long it may be pursued [s]; empty: as long as it takes. */
  public OptionalDouble timeLimit() {
    return get(TIME_LIMIT);
  }

  /** Sets {@link #timeLimit()}. */
  public GoalInformation timeLimit(double seconds) {
    return put(TIME_LIMIT, seconds);
  }

  /**
   * How many of several next goals are to be completed, whichever; empty: as the Mission Manager is
   * configured.
   */
  public OptionalLong choose() {
    return optionalCount(CHOOSE);
  }

  /** Sets {@link #choose()}. */
  public GoalInformation choose(long goals) {
    return put(CHOOSE, goals);
  }

  /** What follows this result and no other, in place of {@link #next()}; empty: nothing special. */
  public Optional<List<String>> nextIf(GoalResult result) {
    return Optional.ofNullable(nextField(result)).map(this::get);
  }

  /**
   * Sets {@link #nextIf}.
   *
   * @param result DONE, FAILED or TIMED_OUT
   * @param uids none: the mission ends
   */
  public GoalInformation nextIf(GoalResult result, List<String> uids) {
    ValueField<GoalInformation, List<String>> field = nextField(result);
    if (field == null) {
      throw new IllegalArgumentException(
          "nextIf: " + result + " has no goals of its own; expected DONE, FAILED or TIMED_OUT");
    }
    return put(field, List.copyOf(uids));
  }

  private static ValueField<GoalInformation, List<String>> nextField(GoalResult result) {
    switch (result) {
      case DONE:
        return NEXT_IF_DONE;
      case FAILED:
        return NEXT_IF_FAILED;
      case TIMED_OUT:
        return NEXT_IF_TIMED_OUT;
      default:
        return null;
    }
  }

  /**
   * UID of the goal with which the mission goes on {@link #repeatTimes()} times after this one,
   * before what {@link #next()} says; empty: no repetition.
   */
  public Optional<String> repeatFrom() {
    return Optional.ofNullable(get(REPEAT_FROM));
  }

  /** Sets {@link #repeatFrom()}. */
  public GoalInformation repeatFrom(String uid) {
    return put(REPEAT_FROM, uid);
  }

  /** How often the mission goes back to {@link #repeatFrom()}; empty: once. */
  public OptionalLong repeatTimes() {
    return optionalCount(REPEAT_TIMES);
  }

  /** Sets {@link #repeatTimes()}. */
  public GoalInformation repeatTimes(long times) {
    return put(REPEAT_TIMES, times);
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
