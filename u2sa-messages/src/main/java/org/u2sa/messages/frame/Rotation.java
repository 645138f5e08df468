package org.u2sa.messages.frame;

/**
 * A proper rotation or axis exchange, as a 3 × 3 matrix that transforms vectors from one set of
 * axes to another. Immutable.
 */
public final class Rotation {
  /** Exchanges east-north-up and north-east-down; its own inverse. */
  public static final Rotation NED_FROM_ENU = rows(0, 1, 0, 1, 0, 0, 0, 0, -1);

  private final double[] m; // row-major

  private Rotation(double[] m) {
    this.m = m;
  }

  static Rotation rows(double... nine) {
    return new Rotation(nine.clone());
  }

  /**
   * Rotation from FRD to NED: yaw, then pitch, then roll (Stevens and Lewis, 2nd ed., section 1.3).
   *
   * @param phi right wing down [rad]
   * @param theta nose up [rad]
   * @param psi clockwise from north [rad]
   */
  public static Rotation nedFromFrd(double phi, double theta, double psi) {
    double sinPhi = Math.sin(phi);
    double cosPhi = Math.cos(phi);
    double sinTheta = Math.sin(theta);
    double cosTheta = Math.cos(theta);
    double sinPsi = Math.sin(psi);
    double cosPsi = Math.cos(psi);
    return rows(
        cosTheta * cosPsi,
        sinPhi * sinTheta * cosPsi - cosPhi * sinPsi,
        cosPhi * sinTheta * cosPsi + sinPhi * sinPsi,
        cosTheta * sinPsi,
        sinPhi * sinTheta * sinPsi + cosPhi * cosPsi,
        cosPhi * sinTheta * sinPsi - sinPhi * cosPsi,
        -sinTheta,
        sinPhi * cosTheta,
        cosPhi * cosTheta);
  }

  /**
   * Rotation from east-north-up to axes whose y axis points {@code angle} clockwise from north
   * [rad].
   */
  public static Rotation aboutUp(double angle) {
    double sin = Math.sin(angle);
    double cos = Math.cos(angle);
    return rows(cos, -sin, 0.0, sin, cos, 0.0, 0.0, 0.0, 1.0);
  }

  /** Rotation of a quaternion other than 0, scalar first, of any length. */
  public static Rotation ofQuaternion(double w, double x, double y, double z) {
    double s = 2.0 / (w * w + x * x + y * y + z * z);
    return rows(
        1.0 - s * (y * y + z * z),
        s * (x * y - w * z),
        s * (x * z + w * y),
        s * (x * y + w * z),
        1.0 - s * (x * x + z * z),
        s * (y * z - w * x),
        s * (x * z - w * y),
        s * (y * z + w * x),
        1.0 - s * (x * x + y * y));
  }

  /** Transforms a vector. */
  public Point times(Point v) {
    return Point.of(
        m[0] * v.x() + m[1] * v.y() + m[2] * v.z(),
        m[3] * v.x() + m[4] * v.y() + m[5] * v.z(),
        m[6] * v.x() + m[7] * v.y() + m[8] * v.z());
  }

  /** Composition: {@code other} first, then this. */
  public Rotation times(Rotation other) {
    double[] product = new double[9];
    for (int row = 0; row < 3; row++) {
      for (int column = 0; column < 3; column++) {
        for (int k = 0; k < 3; k++) {
          product[3 * row + column] += m[3 * row + k] * other.m[3 * k + column];
        }
      }
    }
    return new Rotation(product);
  }

  /** Inverse. */
  public Rotation transposed() {
    return rows(m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]);
  }

  /**
   * Transforms standard deviations of errors that are independent along the source axes;
   * correlations are dropped.
   */
  public Point timesSigma(Point sigma) {
    double[] squared = new double[9];
    for (int i = 0; i < 9; i++) {
      squared[i] = m[i] * m[i];
    }
    Point variance =
        new Rotation(squared)
            .times(Point.of(sigma.x() * sigma.x(), sigma.y() * sigma.y(), sigma.z() * sigma.z()));
    return Point.of(Math.sqrt(variance.x()), Math.sqrt(variance.y()), Math.sqrt(variance.z()));
  }

  /** Roll [rad, -π…π] of the vehicle, if this turns FRD into NED. */
  public double phi() {
    return Math.atan2(m[7], m[8]);
  }

  /** Pitch [rad, -π/2…π/2] of the vehicle, if this turns FRD into NED. */
  public double theta() {
    return Math.asin(Math.max(-1.0, Math.min(1.0, -m[6])));
  }

  /** Heading [rad, clockwise from north, 0…2π) of the vehicle, if this turns FRD into NED. */
  public double psi() {
    double psi = Math.atan2(m[3], m[0]);
    return psi < 0.0 ? psi + 2.0 * Math.PI : psi;
  }
}
