package org.u2sa.messages;

import java.util.List;

/** All current goals of the mission, of which the Path Planner chooses (thesis 3.2.3.2). */
public final class GoalList extends U2SAData {
  private static final Schema<GoalList> SCHEMA =
      Schema.of("GoalList", GoalList.class, GoalList::new, U2SAData.TYPE);
  private static final ValueField<GoalList, List<GoalInformation>> GOALS =
      SCHEMA.messages("goals", GoalInformation.TYPE);

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
}
