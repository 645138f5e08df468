package org.u2sa.planning;

import java.util.Optional;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.goal.GoalInformation;

/**
 * Input of a planner state.
 *
 * @param goal current goal
 * @param before goal finished just before, from which the vehicle comes; empty at mission start and
 *     after an order to change goals
 * @param after most likely next goal, for anticipation; empty at the end
 * @param state the newest estimate
 * @param missionS time since mission start [s], the time base of goals
 */
public record Pursuit(
    GoalInformation goal,
    Optional<GoalInformation> before,
    Optional<GoalInformation> after,
    StateInformation state,
    double missionS) {
  /** Creates a pursuit at mission start. */
  public Pursuit(
      GoalInformation goal,
      Optional<GoalInformation> before,
      Optional<GoalInformation> after,
      StateInformation state) {
    this(goal, before, after, state, 0.0);
  }
}
