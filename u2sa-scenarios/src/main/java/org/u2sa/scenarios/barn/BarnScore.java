package org.u2sa.scenarios.barn;

import java.util.Locale;

/**
 * How one world was driven, scored as in the BARN Challenge of 2022: success · OT / clip(AT, 4 OT,
 * 8 OT), with the optimal time OT = length of the shortest way / the robot's top speed, and the
 * actual time AT from the first 0.1 m on (run.py of the challenge; Xiao et al., IEEE Robotics and
 * Automation Magazine 29-4, 2022).
 *
 * @param number of the world
 * @param pathM length of the shortest way [m]
 * @param outcome what came of it
 * @param timeS actual time [s]
 */
record BarnScore(int number, double pathM, Outcome outcome, double timeS) {
  /** The best that a world can score. */
  static final double BEST = 0.25;

  private static final double SOONEST = 4.0; // in optimal times
  private static final double LATEST = 8.0;

  /** What came of a drive. */
  enum Outcome {
    /** At the goal without a touch. */
    REACHED,
    /** Something was touched. */
    TOUCHED,
    /** The vehicle gave the goal up, or its time was over. */
    NOT_REACHED
  }

  /** The challenge's metric, 0…{@link #BEST}, for a robot of that top speed [m/s]. */
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
