package org.u2sa.control.ground;

/**
 * Settings of {@link PursuitLaw}.
 *
 * @param largestCurvature maximum curvature to drive [1/m]
 */
record PursuitSettings(PursuitVariables tuning, double largestCurvature, SpotTurn spotTurn) {
  /**
   * Settings of turns in place.
   *
   * @param possible whether the vehicle can turn in place
   * @param aboveRad bearing above which a turn starts [rad]
   * @param belowRad bearing below which it ends [rad]
   * @param gain yaw rate per radian of bearing [1/s]
   */
  record SpotTurn(boolean possible, double aboveRad, double belowRad, double gain) {
    /** For vehicles that can only drive curves. */
    static final SpotTurn NONE = new SpotTurn(false, Math.PI, Math.PI, 0.0);
  }
}
