package org.u2sa.scenarios.barn;

import java.util.Locale;

/**
 * Score of one world as in the BARN Challenge of 2022: success · OT / clip(AT, 4 OT, 8 OT), with
 * the optimal time OT = length of the shortest path / top speed of the robot, and the actual time
 * AT counted from the first 0.1 m (run.py of the challenge; Xiao et al., IEEE Robotics and
 * Automation Magazine 29-4, 2022).
 *
 * @param number number of the world
 * @param pathM length of the shortest path [m]
 * @param outcome outcome of the drive
 * @param timeS actual time [s]
 */
record BarnScore(int number, double pathM, Outcome outcome, double timeS) {
  /** Maximum score of a world. */
  static final double BEST = 0.25;

  private static final double SOONEST = 4.0; // in optimal times
  private static final double LATEST = 8.0;

  /** Outcome of a drive. */
  enum Outcome {
    /** Reached the goal without a collision. */
    REACHED,
    /** Collided with something. */
    TOUCHED,
    /** Gave up the goal, or ran out of time. */
    NOT_REACHED
  }

  /** The challenge's metric, 0…{@link #BEST}, for a robot with this top speed [m/s]. */
  double metric(double topMps) {
    if (outcome != Outcome.REACHED) {
      return 0.0;
    }
    double optimalS = pathM / topMps;
    return optimalS / Math.max(SOONEST * optimalS, Math.min(LATEST * optimalS, timeS));
  }

  /** A line of the table. */
  String line(double topMps) {
    return String.format(
        Locale.ROOT,
        "%5d  %-11s  %6.2f  %7.1f  %6.3f",
        number,
        outcome.name().toLowerCase(Locale.ROOT).replace('_', ' '),
        pathM,
        timeS,
        metric(topMps));
  }
}
