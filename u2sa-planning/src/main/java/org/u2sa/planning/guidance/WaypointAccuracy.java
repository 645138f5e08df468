package org.u2sa.planning.guidance;

import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.goal.Waypoint;

/**
 * Adapts waypoints' horizontal thresholds to the accuracy reported in the state. With a standard
 * deviation of σ along each axis, a position is within r of its estimate with a probability of 1 −
 * exp(−r² / 2σ²) (Rayleigh distribution).
 */
public final class WaypointAccuracy {
  /** Standard deviations for 86 % probability. */
  private static final double SURE_SIGMAS = 2.0;

  private static final double SMALLEST_SHARE = 0.5; // limit of the reduction
  private static final double FULL_PERCENT = 100.0;

  private WaypointAccuracy() {}

  /** Standard deviation of the horizontal position, worse axis [m]; empty if not reported. */
  public static OptionalDouble sigmaM(StateInformation state) {
    if (state.xSigma().isEmpty() && state.ySigma().isEmpty()) {
      return OptionalDouble.empty();
    }
    return OptionalDouble.of(Math.max(state.xSigma().orElse(0.0), state.ySigma().orElse(0.0)));
  }

  /**
   * Estimated distance that ensures the vehicle is truly within the threshold [m]: the threshold
   * less two standard deviations, but at least half of it.
   */
  public static double surelyWithinM(double thresholdM, StateInformation state) {
    return thresholdM
        - Math.min(SURE_SIGMAS * sigmaM(state).orElse(0.0), SMALLEST_SHARE * thresholdM);
  }

  /**
   * Returns the goal with a threshold adapted to the accuracy.
   *
   * @param sigmas minimum threshold in standard deviations; 0 leaves the threshold unchanged
   * @return the goal itself, unless it is a waypoint with a smaller threshold
   */
  public static GoalInformation following(
      GoalInformation goal, StateInformation state, double sigmas) {
    double leastM = sigmas * sigmaM(state).orElse(0.0);
    if (!(goal instanceof Waypoint waypoint) || waypoint.horizontalThreshold() >= leastM) {
      return goal;
    }
    Waypoint wider = waypoint.copy();
    wider.horizontalThreshold(leastM);
    return wider;
  }

  /**
   * Warning if a waypoint's threshold is too small for the accuracy; otherwise empty, as for one of
   * altitude alone.
   *
   * @param goal goal with the threshold in effect
   */
  public static Optional<String> remark(GoalInformation goal, StateInformation state) {
    double sigma = sigmaM(state).orElse(0.0);
    if (!(goal instanceof Waypoint waypoint)
        || isOfAltitudeAlone(waypoint)
        || waypoint.horizontalThreshold() >= SURE_SIGMAS * sigma) {
      return Optional.empty();
    }
    double ratio = waypoint.horizontalThreshold() / sigma;
    return Optional.of(
        String.format(
            Locale.ROOT,
            "waypoint \"%s\" may be missed although it seems reached: the position is known to"
                + " %.1f m (1 sigma), so its threshold of %.1f m is truly met with a probability of"
                + " %.0f %%; thresholds of %.1f m or more can be relied on, and THRESHOLD SIGMAS"
                + " lets thresholds follow the accuracy",
            waypoint.uid(),
            sigma,
            waypoint.horizontalThreshold(),
            FULL_PERCENT * -Math.expm1(-0.5 * ratio * ratio),
            SURE_SIGMAS * sigma));
  }

  /** Whether it has no horizontal position; a station without one is where the vehicle was. */
  private static boolean isOfAltitudeAlone(Waypoint waypoint) {
    return !(waypoint instanceof Station) && waypoint.x().isEmpty() && waypoint.y().isEmpty();
  }
}
