package org.u2sa.core.control.ground;

/**
 * What {@link PursuitLaw} goes by.
 *
 * @param largestCurvature that the vehicle can drive, or is to [1/m]
 */
record PursuitSettings(PursuitTuning tuning, double largestCurvature, SpotTurn spotTurn) {
  /**
   * When and how the vehicle turns on the spot.
   *
   * @param possible whether it can at all
   * @param aboveRad bearing above which it does [rad]
   * @param belowRad bearing at which it stops turning [rad]
   * @param gain yaw rate for each radian of direction [1/s]
   */
  record SpotTurn(boolean possible, double aboveRad, double belowRad, double gain) {
    /** For vehicles that can only drive curves. */
    static final SpotTurn NONE = new SpotTurn(false, Math.PI, Math.PI, 0.0);
  }
}
