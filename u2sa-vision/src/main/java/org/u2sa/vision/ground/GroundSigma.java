package org.u2sa.vision.ground;

import org.u2sa.messages.frame.Point;

/**
 * Uncertainty of a ground position seen in an image, from pixel error and camera angles; the error
 * along the ray grows with the square of the distance, the error across it linearly. In range r
 * from a camera at height h, an angle error δ moves the position by δ (r² + h²)/h along the ray and
 * by δ r across.
 *
 * @param pixelRad angular error of a pixel [rad]
 * @param tiltRad standard deviation of the camera's pitch and roll relative to the ground [rad]
 * @param yawRad standard deviation of the camera's yaw [rad]
 * @param ownM distance-independent error: mounting, paint edges [m]
 * @param heightM standard deviation of the ground's height [m]
 */
public record GroundSigma(
    double pixelRad, double tiltRad, double yawRad, double ownM, double heightM) {
  /**
   * Copy for ground of uncertain tilt and height.
   *
   * @param moreRad additional standard deviation of its tilt [rad]
   * @param moreM standard deviation of its height [m]
   */
  public GroundSigma uneven(double moreRad, double moreM) {
    return new GroundSigma(pixelRad, Math.hypot(tiltRad, moreRad), yawRad, ownM, moreM);
  }

  /**
   * Standard deviation along the ray from the point below the camera [m].
   *
   * @param cameraM height of the camera above the ground [m]
   */
  public double alongM(double rangeM, double cameraM) {
    double angle = Math.hypot(pixelRad, tiltRad);
    double byAngle = angle * (rangeM * rangeM + cameraM * cameraM) / cameraM;
    return Math.hypot(ownM, Math.hypot(byAngle, heightM * rangeM / cameraM));
  }

  /** Standard deviation across the ray [m]. */
  public double acrossM(double rangeM) {
    return Math.hypot(ownM, Math.hypot(pixelRad, yawRad) * rangeM);
  }

  /**
   * Standard deviations along the axes forward, right, down [m].
   *
   * @param way vector from the camera to the position, LEVEL
   */
  public Point axes(Point way, double cameraM) {
    double range = Math.hypot(way.x(), way.y());
    return turned(way, alongM(range, cameraM), acrossM(range));
  }

  /** Rotates deviations along and across a direction to the axes forward, right, down [m]. */
  public Point turned(Point way, double along, double across) {
    double range = Math.max(1e-9, Math.hypot(way.x(), way.y()));
    double cos = way.x() / range;
    double sin = way.y() / range;
    return Point.of(
        Math.hypot(along * cos, across * sin), Math.hypot(along * sin, across * cos), ownM);
  }

  /**
   * Uncertainty of the tilt of the ground ahead while the vehicle is on a slope: the slope may
   * continue or end anywhere, so the tilt lies between level and the vehicle's own.
   */
  public static final class SlopeSigma {
    private static final double UNIFORM = Math.sqrt(3.0); // range over standard deviation

    private SlopeSigma() {}

    /**
     * RMS tilt of the ground ahead [rad]; 0 on level ground.
     *
     * @param slopeAboveRad tilt below which the vehicle is assumed to sway on level ground; the
     *     tilt counts fully from twice this value
     */
    public static double rad(double slopeAboveRad, double rollRad, double pitchRad) {
      double tilt = Math.hypot(rollRad, pitchRad);
      double share = Math.max(0.0, Math.min(1.0, (tilt - slopeAboveRad) / slopeAboveRad));
      return share * tilt / UNIFORM;
    }
  }
}
