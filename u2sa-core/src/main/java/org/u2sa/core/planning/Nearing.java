package org.u2sa.core.planning;

import java.util.Locale;
import java.util.Optional;
import org.u2sa.interfaces.time.Clock;

/**
 * Whether a vehicle gets nearer to its goal. Each new route is a fresh hope, also one through a gap
 * that only errors of a sensor show, so only the goal itself tells whether it gets on. Belongs to
 * the planner's thread.
 */
final class Nearing {
  /** A goal to which it gets no nearer is given up when it could have gone so many times there. */
  private static final double MOST_ROUTES = 4.0;

  private double nearestM; // least that was left of any route to this goal [m]
  private double longestM; // most that was left since then [m]
  private long nearestMicros;

  /** The way to another goal begins. */
  void begin(long micros) {
    nearestMicros = micros;
    nearestM = Double.POSITIVE_INFINITY;
    longestM = 0.0;
  }

  /** Some of the time does not count: something else held the vehicle up. */
  void leaveOut(long micros) {
    nearestMicros += micros;
  }

  /**
   * Why what goes to and fro gives up; empty if it does not.
   *
   * @param remainingM of the route [m]
   * @param progressM less is no progress [m]
   * @param speedMps at which it goes when nothing holds it up [m/s]
   * @param heldUpS time in which it may be held up [s]
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
    return seconds > MOST_ROUTES * longestM / speedMps + heldUpS
        ? Optional.of(String.format(Locale.ROOT, "no nearer to the goal for %.0f s", seconds))
        : Optional.empty();
  }
}
