package org.u2sa.scenarios.roboboat;

/**
 * Cost used by the planner to choose among the current tasks (thesis 4.2.1.3): expected duration
 * divided by the probability of success. A task that would leave too little time to get home has
 * infinite cost.
 */
final class TaskChoice {
  private static final double CRUISE_MPS = 0.8; // mean speed, including turns and detours
  private static final double LAST_S = 1.0e6; // cost of a fallback: more than any task's

  private TaskChoice() {}

  /**
   * Returns the cost [s].
   *
   * @param wayM distance to the station [m]
   * @param missionS time since the start of the mission [s]
   */
  static double costS(BoatTask task, double wayM, double missionS) {
    double takesS = wayM / CRUISE_MPS + task.expectedTime();
    if (task.fallback()) {
      return LAST_S + takesS;
    }
    boolean isTooLate = missionS + takesS > task.endBy().orElse(Double.POSITIVE_INFINITY);
    return isTooLate ? Double.POSITIVE_INFINITY : takesS / task.successProbability();
  }
}
