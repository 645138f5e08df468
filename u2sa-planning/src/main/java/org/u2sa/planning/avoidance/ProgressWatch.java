package org.u2sa.planning.avoidance;

import java.util.Locale;
import java.util.Optional;
import org.u2sa.interfaces.time.Clock;

/**
 * Monitors the vehicle's progress toward its goal. Every new route looks promising, even through a
 * gap that is a sensor error, so only the remaining distance to the goal counts. Confined to the
 * planner's thread.
 */
final class ProgressWatch {
  /** Without progress, a goal is given up after the time to travel the route this many times. */
  private static final double MAX_ROUTES = 4.0;

  private double nearestM = Double.POSITIVE_INFINITY; // shortest remaining route to this goal [m]
  private double longestM; // longest remaining route since then [m]
  private long nearestMicros;

  /**
   * @param micros time at which the goal is begun [µs]
   */
  ProgressWatch(long micros) {
    nearestMicros = micros;
  }

  /** Excludes time in which something else held the vehicle up. */
  void leaveOut(long micros) {
    nearestMicros += micros;
  }

  /**
   * Reason for giving up a goal without progress, or empty.
   *
   * @param remainingM remaining length of the route [m]
   * @param progressM minimum progress [m]
   * @param speedMps unobstructed speed [m/s]
   * @param heldUpS allowance for being held up [s]
   */
  Optional<String> circles(
      double remainingM, double progressM, double speedMps, double heldUpS, long micros) {
    longestM = Math.max(longestM, remainingM);
    if (remainingM < nearestM - progressM) {
      nearestM = remainingM;
      longestM = remainingM;
      nearestMicros = micros;
    }
    double seconds = Clock.seconds(micros - nearestMicros);
    return seconds > MAX_ROUTES * longestM / speedMps + heldUpS
        ? Optional.of(String.format(Locale.ROOT, "no nearer to the goal for %.0f s", seconds))
        : Optional.empty();
  }
}
