package org.u2sa.planning;

import org.u2sa.messages.StateInformation;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.service.handover.HandOver;

/**
 * State of a {@link PathPlanner}'s state machine, which pursues one class of goals (thesis
 * 3.2.3.4).
 *
 * <p>Extensions supply their own through a {@link PlannerStateProvider}. A goal is pursued by the
 * state whose {@link #goalClass} is the closest superclass. All calls are made on the planner's
 * thread.
 */
public interface PlannerState {
  /** Class of goals, including subclasses unless another state is closer. */
  Class<? extends GoalInformation> goalClass();

  /**
   * Whether a goal can be pursued without a State Estimator, using only objects seen from the
   * vehicle (thesis 4.3.2). {@link #plan} is then called with a state at the origin that faces
   * north, in a world that contains only the objects in BODY.
   */
  default boolean needsNoState() {
    return false;
  }

  /** Starts the pursuit of a goal and resets the state of the previous one. */
  void enter(Pursuit pursuit);

  /** Plans the next step. Called for each state estimate while the goal is pursued. */
  Plan plan(Pursuit pursuit);

  /** Whether the vehicle was about to touch down, or had, at the last {@link #plan}. */
  default boolean touchesDown() {
    return false;
  }

  /**
   * Distance of a candidate goal [m]; the planner chooses the nearest. Called for goals of {@link
   * #goalClass} only.
   *
   * @throws IllegalArgumentException if the goal cannot be pursued from that state, for example
   *     because of its frame
   */
  double distanceM(GoalInformation goal, StateInformation state);

  /** Whether a restarted planner must know of a change of this state; once for each change. */
  default boolean isNews() {
    return false;
  }

  /**
   * Resumes a manoeuvre that a restart has interrupted, after {@link #enter} for the same goal, if
   * the vehicle is still in it.
   *
   * @param state written by {@link #handOver} at the last {@linkplain #isNews news}, possibly long
   *     ago
   */
  default void resume(HandOver state, Pursuit pursuit) {}

  /** Saves the state of the current pursuit for the planner that takes over. */
  default void handOver(HandOver state) {}

  /**
   * Resumes the pursuit of the previous planner.
   *
   * @return false if the saved state is insufficient; the goal is then {@linkplain #enter entered}
   *     again
   */
  default boolean takeOver(HandOver state) {
    return false;
  }
}
