package org.u2sa.messages.frame;

/**
 * Euler angles of FRD vehicle axes relative to north, east, down, and their relation to body rates.
 *
 * @param phi roll, right wing down positive [rad]
 * @param theta pitch, nose up positive [rad]
 * @param psi heading, clockwise from north [rad]
 */
public record Attitude(double phi, double theta, double psi) {
  private static final double VERTICAL =
      1e-9; // cos θ below which roll and heading are indistinguishable

  /** Extracts the angles of a rotation from FRD to NED. */
  public static Attitude of(Rotation nedFromFrd) {
    return new Attitude(nedFromFrd.phi(), nedFromFrd.theta(), nedFromFrd.psi());
  }

  /** Rotation from FRD to NED. */
  public Rotation nedFromFrd() {
    return Rotation.nedFromFrd(phi, theta, psi);
  }

  /**
   * Converts a north, east, down vector to the thesis's BODY axes (forward, left, down), as
   * navigation points need.
   */
  public Point bodyOf(Point ned) {
    Point frd = nedFromFrd().transposed().times(ned);
    return Point.of(frd.x(), -frd.y(), frd.z());
  }

  /** Converts a vector in BODY axes to north, east, down: the inverse of {@link #bodyOf}. */
  public Point nedOf(Point body) {
    return nedFromFrd().times(Point.of(body.x(), -body.y(), body.z()));
  }

  /** Converts a north, east, down vector to forward, left, down of the levelled vehicle. */
  public Point levelOf(Point ned) {
    double sin = Math.sin(psi);
    double cos = Math.cos(psi);
    return Point.of(ned.x() * cos + ned.y() * sin, ned.x() * sin - ned.y() * cos, ned.z());
  }

  /**
   * Converts Euler rates to rates p, q, r about the FRD axes [rad/s] (Stevens and Lewis, 2nd ed.,
   * section 1.3).
   */
  public Point bodyRates(Point euler) {
    double sinPhi = StrictMath.sin(phi); // strict: control laws are reproducible on every machine
    double cosPhi = StrictMath.cos(phi);
    double cosTheta = StrictMath.cos(theta);
    return Point.of(
        euler.x() - StrictMath.sin(theta) * euler.z(),
        cosPhi * euler.y() + euler.z() * sinPhi * cosTheta,
        euler.z() * cosPhi * cosTheta - euler.y() * sinPhi);
  }

  /**
   * Converts rates p, q, r about the FRD axes to Euler rates [rad/s] (Stevens and Lewis, 2nd ed.,
   * section 1.3).
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
   * Part of the derivative of {@link #bodyRates} due to the changing angles, at the given Euler
   * rates [rad/s²].
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
