package org.u2sa.messages.goal;

import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/**
 * The current goals of the mission, from which the Path Planner chooses (thesis 3.2.3.2). An empty
 * list means that the mission is over.
 */
public final class GoalList extends U2SAData {
  private static final Schema<GoalList> SCHEMA =
      Schema.of(GoalList.class, GoalList::new, U2SAData.TYPE);
  private static final ValueField<GoalList, List<GoalInformation>> GOALS =
      SCHEMA.messages("goals", GoalInformation.TYPE);
  private static final ValueField<GoalList, List<GoalInformation>> UPCOMING =
      SCHEMA.messages("upcoming", GoalInformation.TYPE);
  private static final ValueField<GoalList, Long> LAND_GOALS =
      SCHEMA.since(3).optionalCount("landGoals", "");
  private static final ValueField<GoalList, List<String>> FILE_FAULTS =
      SCHEMA.optionalNotes("fileFaults");
  private static final ValueField<GoalList, Boolean> PAUSED = SCHEMA.optionalFlag("paused");
  private static final NumberField<GoalList> ELAPSED = SCHEMA.optionalNumber("elapsed", "s", 0.0);
  private static final ValueField<GoalList, Boolean> RETURNING = SCHEMA.optionalFlag("returning");

  public static final MessageType<GoalList> TYPE = SCHEMA.build();

  @Override
  public MessageType<GoalList> type() {
    return TYPE;
  }

  /** The goals in the mission's order. */
  public List<GoalInformation> goals() {
    return require(GOALS);
  }

  public GoalList goals(List<? extends GoalInformation> value) {
    return put(GOALS, List.copyOf(value));
  }

  /**
   * The goals that become current when one of {@link #goals()} is completed, so that a planner can
   * look ahead; empty at the end of the mission. If several goals are current, each of these
   * follows only the goal whose {@link GoalInformation#next()} lists it.
   */
  public List<GoalInformation> upcoming() {
    return require(UPCOMING);
  }

  public GoalList upcoming(List<? extends GoalInformation> value) {
    return put(UPCOMING, List.copyOf(value));
  }

  /**
   * Number of goals in the mission loaded for the failsafe LAND; 0: no such mission. Empty from
   * senders that predate the field.
   */
  public OptionalLong landGoals() {
    return optionalCount(LAND_GOALS);
  }

  public GoalList landGoals(long value) {
    return put(LAND_GOALS, value);
  }

  /** Current faults of the loaded mission files, one text each. */
  public List<String> fileFaults() {
    List<String> value = get(FILE_FAULTS);
    return value == null ? List.of() : value;
  }

  public GoalList fileFaults(List<String> value) {
    return put(FILE_FAULTS, List.copyOf(value));
  }

  /**
   * Whether the mission is paused: the vehicle holds its position, or circles if it cannot stop,
   * and pursues none of {@link #goals()}. False from senders that predate the field.
   */
  public boolean paused() {
    return Boolean.TRUE.equals(get(PAUSED));
  }

  public GoalList paused(boolean value) {
    return put(PAUSED, value);
  }

  /**
   * Whether {@link #goals()} lead home or to a landing on request of a failsafe or operator: an
   * aircraft on the ground does not take off for them. False from senders that predate the field.
   */
  public boolean returning() {
    return Boolean.TRUE.equals(get(RETURNING));
  }

  public GoalList returning(boolean value) {
    return put(RETURNING, value);
  }

  /**
   * Mission time at publication [s]: time while armed, without pauses and failsafes. It advances
   * while the mission is pursued. Empty from senders unaware of the field.
   */
  public OptionalDouble elapsed() {
    return get(ELAPSED);
  }

  /** Sets {@link #elapsed()}; not negative. */
  public GoalList elapsed(double seconds) {
    return put(ELAPSED, seconds);
  }
}
