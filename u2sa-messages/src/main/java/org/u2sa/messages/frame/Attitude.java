package org.u2sa.messages.frame;

/**
 * Euler angles of FRD vehicle axes against north, east, down, and how their derivatives follow the
 * vehicle's own rates.
 *
 * @param phi roll, right wing down positive [rad]
 * @param theta pitch, nose up positive [rad]
 * @param psi heading, clockwise from north [rad]
 */
public record Attitude(double phi, double theta, double psi) {
  private static final double VERTICAL =
      1e-9; // cos θ below which roll and heading are one and the same

  /** The angles of a rotation from FRD to NED. */
  public static Attitude of(Rotation nedFromFrd) {
    return new Attitude(nedFromFrd.phi(), nedFromFrd.theta(), nedFromFrd.psi());
  }

  /** Turns FRD vectors into NED ones. */
  public Rotation nedFromFrd() {
    return Rotation.nedFromFrd(phi, theta, psi);
  }

  /**
   * A vector given as north, east, down, in the thesis's BODY axes: forward, left, down. This is
   * how a navigation point is made.
   */
  public Point bodyOf(Point ned) {
    Point frd = nedFromFrd().transposed().times(ned);
    return Point.of(frd.x(), -frd.y(), frd.z());
  }

  /** A vector given in BODY axes as north, east, down: undoes {@link #bodyOf}. */
  public Point nedOf(Point body) {
    return nedFromFrd().times(Point.of(body.x(), -body.y(), body.z()));
  }

  /** A vector given as north, east, down, seen by a level vehicle: forward, left, down. */
  public Point levelOf(Point ned) {
    double sin = Math.sin(psi);
    double cos = Math.cos(psi);
    return Point.of(ned.x() * cos + ned.y() * sin, ned.x() * sin - ned.y() * cos, ned.z());
  }

  /**
   * Rates p, q, r about the FRD axes [rad/s] of Euler rates (Stevens and Lewis, 2nd ed., section
   * 1.3).
   */
  public Point bodyRates(Point euler) {
    double sinPhi = StrictMath.sin(phi); // strict: control laws repeat on every machine
    double cosPhi = StrictMath.cos(phi);
    double cosTheta = StrictMath.cos(theta);
    return Point.of(
        euler.x() - StrictMath.sin(theta) * euler.z(),
        cosPhi * euler.y() + euler.z() * sinPhi * cosTheta,
        euler.z() * cosPhi * cosTheta - euler.y() * sinPhi);
  }

  /**
   * Euler rates [rad/s] of rates p, q, r about the FRD axes (Stevens and Lewis, 2nd ed., section
   * 1.3).
   *
   * @throws IllegalArgumentException if the nose points straight up or down
   */
  public Point eulerRates(Point body) {
    double cosTheta = Math.cos(theta);
    if (Math.abs(cosTheta) < VERTICAL) {
      throw new IllegalArgumentException(
          "theta: " + theta + " rad is vertical, where Euler rates are not defined");
    }
    double sinPhi = Math.sin(phi);
    double cosPhi = Math.cos(phi);
    double psiRate = (sinPhi * body.y() + cosPhi * body.z()) / cosTheta;
    return Point.of(
        body.x() + Math.sin(theta) * psiRate, cosPhi * body.y() - sinPhi * body.z(), psiRate);
  }

  /**
   * What {@link #bodyRates} gains in a second by the angles' own change, at the given Euler rates
   * [rad/s²].
   */
  public Point bodyRatesDrift(Point euler) {
    double sinPhi = Math.sin(phi);
    double cosPhi = Math.cos(phi);
    double sinTheta = Math.sin(theta);
    double cosTheta = Math.cos(theta);
    double p = euler.x();
    double q = euler.y();
    double r = euler.z();
    return Point.of(
        -cosTheta * q * r,
        -sinPhi * p * q + (cosPhi * cosTheta * p - sinPhi * sinTheta * q) * r,
        -cosPhi * p * q - (sinPhi * cosTheta * p + cosPhi * sinTheta * q) * r);
  }
}
