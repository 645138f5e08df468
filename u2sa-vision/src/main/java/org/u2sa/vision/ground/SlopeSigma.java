package org.u2sa.vision.ground;

/**
 * Uncertainty of the tilt of the ground ahead while the vehicle is on a slope: the slope may
 * continue or end anywhere, so the tilt lies between level and the vehicle's own.
 */
public final class SlopeSigma {
  private static final double UNIFORM = Math.sqrt(3.0); // range over standard deviation

  private SlopeSigma() {}

  /**
   * RMS tilt of the ground ahead [rad]; 0 on level ground.
   *
   * @param slopeAboveRad tilt below which the vehicle is taken to sway on level ground; counts
   *     fully from twice this value
   */
  public static double rad(double slopeAboveRad, double rollRad, double pitchRad) {
    double tilt = Math.hypot(rollRad, pitchRad);
    double share = Math.max(0.0, Math.min(1.0, (tilt - slopeAboveRad) / slopeAboveRad));
    return share * tilt / UNIFORM;
  }
}
