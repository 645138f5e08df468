package org.u2sa.vision.ground;

import org.u2sa.messages.frame.Point;

/**
 * How well a place on the ground is known from a picture: a pixel's error and the camera's angles,
 * which do to the distance by its square what they do to the side by its first power. In range r
 * from a camera at height h, an angle δ moves the place by δ (r² + h²)/h along the ray and by δ r
 * across.
 *
 * @param pixelRad angle of a pixel's error [rad]
 * @param tiltRad standard deviation of the camera's pitch and roll against the ground [rad]
 * @param yawRad standard deviation of its direction [rad]
 * @param ownM error that does not depend on the distance: mounting, the paint's own edge [m]
 */
public record GroundSigma(double pixelRad, double tiltRad, double yawRad, double ownM) {
  /** The same on ground whose tilt is known less well, by so much more [rad]. */
  public GroundSigma tilted(double moreRad) {
    return new GroundSigma(pixelRad, Math.hypot(tiltRad, moreRad), yawRad, ownM);
  }

  /** Along the ray from the camera's foot [m]. */
  public double alongM(double rangeM, double heightM) {
    double angle = Math.hypot(pixelRad, tiltRad);
    return Math.hypot(ownM, angle * (rangeM * rangeM + heightM * heightM) / heightM);
  }

  /** Across it [m]. */
  public double acrossM(double rangeM) {
    return Math.hypot(ownM, Math.hypot(pixelRad, yawRad) * rangeM);
  }

  /**
   * Along the axes forward, to the right, down [m].
   *
   * @param way from the camera to the place, LEVEL
   */
  public Point axes(Point way, double heightM) {
    double range = Math.hypot(way.x(), way.y());
    return turned(way, alongM(range, heightM), acrossM(range));
  }

  /** Standard deviations along and across a direction, along the axes forward, right, down [m]. */
  public Point turned(Point way, double along, double across) {
    double range = Math.max(1e-9, Math.hypot(way.x(), way.y()));
    double cos = way.x() / range;
    double sin = way.y() / range;
    return Point.of(
        Math.hypot(along * cos, across * sin), Math.hypot(along * sin, across * cos), ownM);
  }
}
