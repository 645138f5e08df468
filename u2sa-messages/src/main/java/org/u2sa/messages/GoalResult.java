package org.u2sa.messages;

/** What came of a goal. The order is that of the wire. */
public enum GoalResult {
  /** It was reached. */
  DONE,
  /** The Path Planner gave it up. */
  FAILED,
  /** Its time limit, or the mission's, passed. */
  TIMED_OUT,
  /** An operator ended it. */
  SKIPPED
}
