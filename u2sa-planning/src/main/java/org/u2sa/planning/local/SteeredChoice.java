package org.u2sa.planning.local;

import java.util.Optional;
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
  private static final double SAME_M = 0.05; // smaller differences of distances are ignored
  private static final double KEEPS = 0.3; // advantage of the direction before, in reaches
  private static final double KEEPS_S = 0.5; // likewise, of the time until a collision
  private static final double KEEPS_M = 0.3; // likewise, of the distance

  private final SteeredForecast forecast;
  private final MotionLimits limits;
  private final Pose pose;
  private final Optional<ArcChoice> before;

  /**
   * @param before choice at the previous state: an evasion goes on in its direction unless another
   *     one is clearly better, because turning round takes seconds
   */
  SteeredChoice(
      SteeredForecast forecast, MotionLimits limits, Pose pose, Optional<ArcChoice> before) {
    this.forecast = forecast;
    this.limits = limits;
    this.pose = pose;
    this.before =
        before.filter(
            choice ->
                choice.speedMps() > 0.0
                    && (choice.kind() == ArcChoice.Kind.EVADE
                        || choice.kind() == ArcChoice.Kind.BRAKE));
  }

  private boolean goesOn(double course, boolean backwards) {
    if (before.isEmpty() || before.get().backwards() != backwards) {
      return false;
    }
    double last =
        Math.atan2(before.get().eastM() - pose.eastM(), before.get().northM() - pose.northM());
    return Math.abs(Pose.wrapped(course - last)) <= Math.PI / DIRECTIONS;
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

  /** Whether a motion keeps its distance although the boat is carried. */
  boolean isFree(ArcChoice choice) {
    return forecast
        .to(choice.northM(), choice.eastM(), choice.speedMps(), choice.backwards())
        .isFree();
  }

  /** Whether the boat may drift for now. */
  boolean waits() {
    Pose ahead = pose.along(limits.lookAheadM(), 0.0);
    return forecast.to(ahead.northM(), ahead.eastM(), 0.0, false).isFree();
  }

  /**
   * The free direction that leads closest to a point; otherwise the direction, or drifting, after
   * which it collides last or, without a collision, stays farthest away.
   */
  ArcChoice evade(double northM, double eastM) {
    ArcChoice best = null;
    Pose ahead = pose.along(limits.lookAheadM(), 0.0);
    Outcome drifts = forecast.to(ahead.northM(), ahead.eastM(), 0.0, false);
    ArcChoice last = new ArcChoice(ahead.northM(), ahead.eastM(), 0.0, false, ArcChoice.Kind.BRAKE);
    double leastCost = Double.POSITIVE_INFINITY;
    double touchesS = drifts.touchesS();
    double widestM = drifts.leastM();
    for (int k = 0; k < 2 * DIRECTIONS; k++) {
      boolean backwards = k >= DIRECTIONS;
      double course = 2.0 * Math.PI * k / DIRECTIONS;
      double north = pose.northM() + limits.lookAheadM() * Math.cos(course);
      double east = pose.eastM() + limits.lookAheadM() * Math.sin(course);
      double mps = limits.mps(backwards);
      Outcome outcome = forecast.to(north, east, mps, backwards);
      ArcChoice choice = new ArcChoice(north, east, mps, backwards, ArcChoice.Kind.EVADE);
      boolean goesOn = goesOn(course, backwards);
      double cost =
          outcome.end().distanceM(northM, eastM)
              + (backwards ? ASTERN * limits.lookAheadM() : 0.0)
              - (goesOn ? KEEPS * limits.lookAheadM() : 0.0);
      if (outcome.isFree() && cost < leastCost) {
        leastCost = cost;
        best = choice;
      }
      double lastsS = outcome.touchesS() + (goesOn ? KEEPS_S : 0.0);
      double leastM = outcome.leastM() + (goesOn ? KEEPS_M : 0.0);
      if (lastsS > touchesS || lastsS == touchesS && leastM > widestM + SAME_M) {
        touchesS = lastsS;
        widestM = leastM;
        last = choice.as(ArcChoice.Kind.BRAKE);
      }
    }
    return best == null ? last : best;
  }
}
