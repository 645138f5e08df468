package org.u2sa.core.planning;

import java.util.Optional;
import org.u2sa.messages.GoalInformation;
import org.u2sa.messages.StateInformation;

/**
 * What a planner state is to work on.
 *
 * @param goal the goal pursued
 * @param before the goal that was finished just before, from which the vehicle comes; empty at the
 *     start of a mission and after an order to change goals
 * @param after the goal that most likely comes next, for acting ahead of time; empty at the end
 * @param state the newest estimate
 * @param missionS time since the mission began [s], as goals' own times are counted
 */
public record Pursuit(
    GoalInformation goal,
    Optional<GoalInformation> before,
    Optional<GoalInformation> after,
    StateInformation state,
    double missionS) {
  /** A pursuit at the mission's begin. */
  public Pursuit(
      GoalInformation goal,
      Optional<GoalInformation> before,
      Optional<GoalInformation> after,
      StateInformation state) {
    this(goal, before, after, state, 0.0);
  }
}
