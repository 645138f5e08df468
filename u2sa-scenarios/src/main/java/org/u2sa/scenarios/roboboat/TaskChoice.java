package org.u2sa.scenarios.roboboat;

/**
 * Cost of a task, by which the planner chooses among those that are current (thesis 4.2.1.3): the
 * time that it is expected to take, over its probability of success. A task that would leave too
 * little time to get home costs infinitely much.
 */
final class TaskChoice {
  private static final double CRUISE_MPS = 0.8; // on the way, with turns and detours
  private static final double LAST_S = 1.0e6; // of a fallback: more than any task costs

  private TaskChoice() {}

  /**
   * Returns the cost [s].
   *
   * @param wayM distance of the station [m]
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
