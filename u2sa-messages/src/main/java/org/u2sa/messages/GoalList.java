package org.u2sa.messages;

import java.util.List;

/**
 * All current goals of the mission, of which the Path Planner chooses (thesis 3.2.3.2). A list
 * without goals says that the mission is over.
 */
public final class GoalList extends U2SAData {
  private static final Schema<GoalList> SCHEMA =
      Schema.of("GoalList", GoalList.class, GoalList::new, U2SAData.TYPE);
  private static final ValueField<GoalList, List<GoalInformation>> GOALS =
      SCHEMA.messages("goals", GoalInformation.TYPE);
  private static final ValueField<GoalList, List<GoalInformation>> UPCOMING =
      SCHEMA.messages("upcoming", GoalInformation.TYPE);

  /** The schema. */
  public static final MessageType<GoalList> TYPE = SCHEMA.build();

  @Override
  public MessageType<GoalList> type() {
    return TYPE;
  }

  /** The goals in the mission's order. */
  public List<GoalInformation> goals() {
    return require(GOALS);
  }

  /** Sets {@link #goals()}. */
  public GoalList goals(List<? extends GoalInformation> value) {
    put(GOALS, List.copyOf(value));
    return this;
  }

  /**
   * The goals that become current when one of {@link #goals()} is completed, so that a planner can
   * act ahead of time; empty after the last ones. If several goals are current, these are only what
   * comes after the one whose {@link GoalInformation#next()} names them.
   */
  public List<GoalInformation> upcoming() {
    return require(UPCOMING);
  }

  /** Sets {@link #upcoming()}. */
  public GoalList upcoming(List<? extends GoalInformation> value) {
    put(UPCOMING, List.copyOf(value));
    return this;
  }
}
