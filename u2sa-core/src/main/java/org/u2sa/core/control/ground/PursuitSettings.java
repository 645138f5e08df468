package org.u2sa.core.control.ground;

/**
 * The gains and limits of {@link PursuitLaw}.
 *
 * @param cruiseMps speed on a straight [m/s]
 * @param accelerationMps2 with which it gets faster [m/s²]
 * @param brakingMps2 with which it gets slower [m/s²]
 * @param approachM distance to the point from which on it slows down [m]
 * @param approachMps least speed at which it comes to the point [m/s]
 * @param toleranceM distance at which it has arrived and stands [m]
 * @param regulatedRadiusM tighter curves are driven slower, in proportion to their radius [m]
 * @param largestCurvature that the vehicle can drive, or is to [1/m]
 * @param turnRateRadPerS most yaw rate [rad/s]
 * @param turnAccelerationRadPerS2 with which the yaw rate changes [rad/s²]
 */
record PursuitSettings(
    double cruiseMps,
    double accelerationMps2,
    double brakingMps2,
    double approachM,
    double approachMps,
    double toleranceM,
    double regulatedRadiusM,
    double largestCurvature,
    double turnRateRadPerS,
    double turnAccelerationRadPerS2,
    SpotTurn spotTurn) {

  /**
   * When and how the vehicle turns on the spot.
   *
   * @param possible whether it can at all
   * @param aboveRad direction of the point from which on it does [rad]
   * @param belowRad direction of the point at which it has turned enough [rad]
   * @param gain yaw rate for each radian of direction [1/s]
   */
  record SpotTurn(boolean possible, double aboveRad, double belowRad, double gain) {
    /** For vehicles that can only drive curves. */
    static final SpotTurn NONE = new SpotTurn(false, Math.PI, Math.PI, 0.0);
  }
}
