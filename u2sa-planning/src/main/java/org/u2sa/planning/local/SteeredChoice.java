package org.u2sa.planning.local;

import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.local.SteeredForecast.Outcome;

/**
 * Chooses the next target of a drifting boat, which can neither stop nor turn in place: the route
 * if the way there is free, otherwise the free direction that leads closest to it, ahead or astern.
 * Not thread-safe.
 */
final class SteeredChoice {
  private static final int DIRECTIONS = 24;
  private static final double ASTERN = 0.5; // cost, in reaches
  private static final double SAME_M = 0.05; // fraction of clearance

  private final SteeredForecast forecast;
  private final MotionLimits limits;
  private final Pose pose;

  SteeredChoice(SteeredForecast forecast, MotionLimits limits, Pose pose) {
    this.forecast = forecast;
    this.limits = limits;
    this.pose = pose;
  }

  ArcChoice along(RouteTrack track) {
    double most = limits.lookAheadM();
    for (double ahead = most; ahead > 0.2 * most; ahead *= 0.6) {
      double north = track.northAheadM(ahead);
      double east = track.eastAheadM(ahead);
      if (forecast.to(north, east, limits.speedMps(), false).isFree()) {
        return new ArcChoice(north, east, limits.speedMps(), false, ArcChoice.Kind.FOLLOW);
      }
    }
    return evade(track.northAheadM(most), track.eastAheadM(most));
  }

  /** Whether the boat may drift for now. */
  boolean waits() {
    Pose ahead = pose.along(limits.lookAheadM(), 0.0);
    return forecast.to(ahead.northM(), ahead.eastM(), 0.0, false).isFree();
  }

  /**
   * The free direction that leads closest to a point; otherwise the one that stays free longest.
   */
  ArcChoice evade(double northM, double eastM) {
    ArcChoice best = null;
    ArcChoice longest = null;
    double leastCost = Double.POSITIVE_INFINITY;
    double hitsS = 0.0;
    double widestM = 0.0;
    for (int k = 0; k < 2 * DIRECTIONS; k++) {
      boolean backwards = k >= DIRECTIONS;
      double course = 2.0 * Math.PI * k / DIRECTIONS;
      double north = pose.northM() + limits.lookAheadM() * Math.cos(course);
      double east = pose.eastM() + limits.lookAheadM() * Math.sin(course);
      double mps = limits.mps(backwards);
      Outcome outcome = forecast.to(north, east, mps, backwards);
      ArcChoice choice = new ArcChoice(north, east, mps, backwards, ArcChoice.Kind.EVADE);
      double cost =
          outcome.end().distanceM(northM, eastM) + (backwards ? ASTERN * limits.lookAheadM() : 0.0);
      if (outcome.isFree() && cost < leastCost) {
        leastCost = cost;
        best = choice;
      }
      boolean isWider = outcome.hitsS() == hitsS && outcome.leastM() > widestM + SAME_M;
      if (outcome.hitsS() > hitsS || isWider) {
        hitsS = outcome.hitsS();
        widestM = outcome.leastM();
        longest = choice.as(ArcChoice.Kind.BRAKE);
      }
    }
    return best == null ? longest : best;
  }
}
