package org.u2sa.planning.guidance;

/**
 * Computes the distance before a waypoint at which a vehicle must start its turn to join the next
 * leg without overshoot.
 *
 * @param accelerationMps2 lateral acceleration of the vehicle's turns [m/s²]: g · tan(bank) for an
 *     aircraft; 0 for a vehicle that turns in place and does not anticipate
 * @param cornerM limit of corner cutting, regardless of the waypoint's threshold [m]
 * @param lagS delay from command to established turn [s]: roll-in of an aircraft
 */
public record TurnAnticipation(double accelerationMps2, double lagS, double cornerM) {
  /**
   * Fraction of a waypoint's horizontal threshold by which an anticipated turn may cut its corner.
   */
  static final double CORNER_SHARE = 0.6;

  /** Radius of the vehicle's turns at a ground speed [m]; 0 for a vehicle that turns in place. */
  public double radiusM(double speedMps) {
    return accelerationMps2 > 0.0 ? speedMps * speedMps / accelerationMps2 : 0.0;
  }

  /** Distance within which to turn to the next waypoint [m]: threshold or corner limit. */
  public double nearM(double thresholdM) {
    double share = accelerationMps2 == 0.0 ? 1.0 : CORNER_SHARE;
    return Math.min(share * thresholdM, cornerM);
  }

  /**
   * Distance before the waypoint at which to start the turn [m].
   *
   * <p>The corner may be cut by up to 60 % of the threshold and no more than the limit. An arc of
   * radius R that starts d before the waypoint passes it at sqrt(d² + R²) − R, so it passes at m or
   * less if d ≤ sqrt(2 R m + m²). Starting at R · tan(θ/2) makes the arc end on the next leg: the
   * turn never needs to start earlier.
   *
   * @param speedMps ground speed [m/s]
   * @param turnRad change of direction at the waypoint [rad], either sign
   * @param insideM cross-track offset towards the inside of the turn [m]; negative outside
   * @param thresholdM the waypoint's horizontal threshold [m]
   */
  double distanceM(double speedMps, double turnRad, double insideM, double thresholdM) {
    double radius = radiusM(speedMps);
    double allowed = Math.min(CORNER_SHARE * thresholdM, cornerM);
    double corner = Math.max(0.0, allowed - Math.max(insideM, -allowed));
    double halfTurn = Math.abs(turnRad) / 2.0;
    double tangent =
        halfTurn < Math.PI / 2.0 ? radius * Math.tan(halfTurn) : Double.POSITIVE_INFINITY;
    double passing = Math.sqrt(2.0 * radius * corner + corner * corner);
    if (radius == 0.0 || corner == 0.0) {
      return 0.0;
    }
    return Math.min(tangent, passing) + speedMps * lagS;
  }
}
