package org.u2sa.vision.ground;

/**
 * How uncertain the tilt of the ground ahead is while the vehicle is on a slope: the slope may go
 * on or end at any place, so it is anything between level and the vehicle's own tilt.
 */
public final class SlopeSigma {
  private static final double UNIFORM = Math.sqrt(3.0); // a whole range by its root mean square

  private SlopeSigma() {}

  /**
   * Root mean square of that tilt [rad]: 0 on level ground.
   *
   * @param slopeAboveRad tilt up to which a vehicle merely sways; from twice that on all counts
   */
  public static double rad(double slopeAboveRad, double rollRad, double pitchRad) {
    double tilt = Math.hypot(rollRad, pitchRad);
    double share = Math.max(0.0, Math.min(1.0, (tilt - slopeAboveRad) / slopeAboveRad));
    return share * tilt / UNIFORM;
  }
}
