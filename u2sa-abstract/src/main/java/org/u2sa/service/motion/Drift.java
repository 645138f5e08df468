package org.u2sa.service.motion;

/**
 * Velocity over ground of a vehicle without lateral thrust due to wind and current. Immutable.
 *
 * @param northMps northward [m/s]
 * @param eastMps eastward [m/s]
 */
public record Drift(double northMps, double eastMps) {
  public static final Drift NONE = new Drift(0.0, 0.0);

  private static final double SLOWEST_MPS = 0.3; // through the water
  private static final double MAX_RAD = Math.toRadians(50.0);

  public double speedMps() {
    return Math.hypot(northMps, eastMps);
  }

  /** Part of the drift in a direction [m/s]. */
  public double towardsMps(double courseRad) {
    return northMps * Math.cos(courseRad) + eastMps * Math.sin(courseRad);
  }

  /**
   * Angle by which the bow must be to the right of a wanted course [rad].
   *
   * @param courseRad over ground, clockwise from north
   * @param aheadMps velocity over ground along the bow
   */
  public double crabRad(double courseRad, double aheadMps) {
    double right = eastMps * Math.cos(courseRad) - northMps * Math.sin(courseRad);
    double through = Math.max(SLOWEST_MPS, aheadMps - towardsMps(courseRad));
    double angle = -Math.asin(Math.max(-1.0, Math.min(1.0, right / through)));
    return Math.max(-MAX_RAD, Math.min(MAX_RAD, angle));
  }
}
