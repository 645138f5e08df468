package org.u2sa.core.planning;

import org.u2sa.messages.GoalInformation;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.HandOver;

/**
 * What one class of goals makes a {@link PathPlanner} do: a state of its state machine (thesis
 * 3.2.3.4).
 *
 * <p>An extension brings its own through a {@link PlannerStateProvider}. A goal is pursued by the
 * state whose {@link #goalClass} is nearest to the goal's own class. All calls come on the
 * planner's thread.
 */
public interface PlannerState {
  /** The class of goals, subclasses included as far as no other state is nearer. */
  Class<? extends GoalInformation> goalClass();

  /**
   * Takes note that the pursuit of a goal begins; what was remembered of the goal before is
   * forgotten.
   */
  void enter(Pursuit pursuit);

  /** Plans the next step. Called for each state estimate while the goal is pursued. */
  Plan plan(Pursuit pursuit);

  /**
   * How far away a goal is that the planner may choose; the planner chooses the nearest [m]. Called
   * for goals of {@link #goalClass} only.
   *
   * @throws IllegalArgumentException if the goal cannot be pursued from that state, for example
   *     because of its frame
   */
  double distanceM(GoalInformation goal, StateInformation state);

  /** Writes down how the pursuit of the present goal stands, for a planner that takes over. */
  default void handOver(HandOver state) {}

  /**
   * Goes on with a pursuit where the planner before was.
   *
   * @return false if what was handed over does not suffice: then the goal is {@linkplain #enter
   *     entered} anew
   */
  default boolean takeOver(HandOver state) {
    return false;
  }
}
