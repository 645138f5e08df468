package org.u2sa.messages.goal;

/** Result of a goal. The order is part of the wire format. */
public enum GoalResult {
  /** Reached. */
  DONE,
  /** Abandoned by the Path Planner. */
  FAILED,
  /** Its time limit, or the mission's, expired. */
  TIMED_OUT,
  /** Skipped by an operator. */
  SKIPPED
}
