package org.u2sa.planning.local;

import org.u2sa.planning.curve.Pose;

/**
 * Velocity over ground with which wind and current carry a vehicle that cannot move sideways.
 * Immutable.
 *
 * @param northMps northward [m/s]
 * @param eastMps eastward [m/s]
 */
public record Drift(double northMps, double eastMps) {
  public static final Drift NONE = new Drift(0.0, 0.0);

  private static final double LEAST_MPS = 0.1; // less does not matter
  private static final double STEERS_MPS = 0.3; // speed through the water at which it still steers
  private static final double MAX_CRAB_RAD = Math.toRadians(50.0); // as control systems allow
  private static final double STEERAGE = 2.0; // speed to be steered at, per speed of the drift

  boolean matters() {
    return speedMps() > LEAST_MPS;
  }

  double speedMps() {
    return Math.hypot(northMps, eastMps);
  }

  /** Least speed at which the vehicle is steered well enough [m/s]. */
  double steerageMps() {
    return matters() ? STEERAGE * speedMps() : 0.0;
  }

  /** Whether a vehicle at this speed along its bow is steered, not only carried [m/s]. */
  boolean steers(double aheadMps) {
    return matters() && aheadMps >= STEERS_MPS;
  }

  Pose moved(Pose from, double seconds) {
    return new Pose(
        from.northM() + seconds * northMps, from.eastM() + seconds * eastMps, from.headingRad());
  }

  /**
   * A pose whose heading is the course over ground, if the vehicle is steered.
   *
   * @param aheadMps velocity over ground along the bow [m/s]
   */
  Pose course(Pose bow, double aheadMps) {
    if (!steers(aheadMps)) {
      return bow;
    }
    double heading = bow.headingRad();
    double course =
        Math.atan2(
            aheadMps * Math.sin(heading) + eastMps, aheadMps * Math.cos(heading) + northMps);
    return new Pose(bow.northM(), bow.eastM(), course);
  }

  /** Angle by which the bow is right of a course over ground against the drift [rad]. */
  double crabRad(double courseRad, double aheadMps) {
    double right = eastMps * Math.cos(courseRad) - northMps * Math.sin(courseRad);
    double share = right / Math.max(STEERS_MPS, aheadMps);
    double angle = -Math.asin(Math.max(-1.0, Math.min(1.0, share)));
    return matters() ? Math.max(-MAX_CRAB_RAD, Math.min(MAX_CRAB_RAD, angle)) : 0.0;
  }
}
