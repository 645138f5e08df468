package org.u2sa.planning.avoidance;

import java.util.Locale;
import java.util.Optional;
import org.u2sa.interfaces.time.Clock;

/**
 * Monitors the vehicle's progress toward its goal. Every new route looks promising, even through a
 * gap that is a sensor error, so only the remaining distance to the goal counts.
 */
final class ProgressWatch {
  /**
   * Without progress, a goal is abandoned after this many times the route's travel time, and the
   * time in which a vehicle that can stop notices that it is stuck, at first and after up to as
   * many attempts to free itself: near the goal, the travel time alone would not suffice for one.
   */
  private static final double MAX_ROUTES = 4.0;

  private final NearestYet nearest = new NearestYet();
  private double longestM; // longest remaining route since then [m]
  private long nearestMicros;

  ProgressWatch(long beginsMicros) {
    nearestMicros = beginsMicros;
  }

  /** Excludes time in which the vehicle was blocked by something else. */
  void leaveOut(long micros) {
    nearestMicros += micros;
  }

  private static double attempts(AvoidanceVariables settings) {
    return settings.stops() ? 1.0 + Math.min(MAX_ROUTES, settings.recoveries()) : 1.0;
  }

  /** Reason for giving up a goal without progress, or empty. */
  Optional<String> circles(double remainingM, Situation now) {
    longestM = Math.max(longestM, remainingM);
    if (nearest.isNearer(remainingM, now)) {
      longestM = remainingM;
      nearestMicros = now.micros();
    }
    double seconds = Clock.seconds(now.micros() - nearestMicros);
    AvoidanceVariables settings = now.settings();
    double stuckS = settings.stuckAfter() * attempts(settings);
    double allowedS = MAX_ROUTES * longestM / now.limits().speedMps() + stuckS;
    return seconds > allowedS
        ? Optional.of(String.format(Locale.ROOT, "no closer to the goal for %.0f s", seconds))
        : Optional.empty();
  }
}
