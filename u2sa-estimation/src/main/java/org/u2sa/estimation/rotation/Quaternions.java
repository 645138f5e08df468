package org.u2sa.estimation.rotation;

/**
 * Unit quaternions w, x, y, z in arrays, which rotate BODY_FRD vectors to north, east, down (Solà
 * 2017, arXiv 1711.02508, sections 2 and 4). Uses StrictMath, so that runs are reproducible on
 * every machine.
 */
public final class Quaternions {
  private static final double SMALL = 1e-8; // rad, where sin(a/2)/a is 1/2 to rounding

  private Quaternions() {}

  /** Sets the quaternion from roll, pitch and heading [rad]. */
  public static void fromEuler(double phi, double theta, double psi, double[] x, int at) {
    double cr = StrictMath.cos(phi / 2.0);
    double sr = StrictMath.sin(phi / 2.0);
    double cp = StrictMath.cos(theta / 2.0);
    double sp = StrictMath.sin(theta / 2.0);
    double cy = StrictMath.cos(psi / 2.0);
    double sy = StrictMath.sin(psi / 2.0);
    x[at] = cr * cp * cy + sr * sp * sy;
    x[at + 1] = sr * cp * cy - cr * sp * sy;
    x[at + 2] = cr * sp * cy + sr * cp * sy;
    x[at + 3] = cr * cp * sy - sr * sp * cy;
  }

  /** Computes the rotation matrix, row by row. */
  public static void matrix(double[] x, int at, double[] r) {
    double w = x[at];
    double a = x[at + 1];
    double b = x[at + 2];
    double c = x[at + 3];
    r[0] = 1.0 - 2.0 * (b * b + c * c);
    r[1] = 2.0 * (a * b - w * c);
    r[2] = 2.0 * (a * c + w * b);
    r[3] = 2.0 * (a * b + w * c);
    r[4] = 1.0 - 2.0 * (a * a + c * c);
    r[5] = 2.0 * (b * c - w * a);
    r[6] = 2.0 * (a * c - w * b);
    r[7] = 2.0 * (b * c + w * a);
    r[8] = 1.0 - 2.0 * (a * a + b * b);
  }

  /** Computes q ← q ⊗ Exp(v), a rotation about the vehicle's axes [rad]. */
  public static void turnBody(double[] x, int at, double vx, double vy, double vz) {
    double s = halfSinc(vx, vy, vz);
    double ew = halfCos(vx, vy, vz);
    multiply(x[at], x[at + 1], x[at + 2], x[at + 3], ew, s * vx, s * vy, s * vz, x, at);
  }

  /** Computes q ← Exp(v) ⊗ q, a rotation about north, east and down [rad]. */
  public static void turnEarth(double[] x, int at, double vx, double vy, double vz) {
    double s = halfSinc(vx, vy, vz);
    double ew = halfCos(vx, vy, vz);
    multiply(ew, s * vx, s * vy, s * vz, x[at], x[at + 1], x[at + 2], x[at + 3], x, at);
  }

  private static double halfSinc(double x, double y, double z) {
    double angle = Math.sqrt(x * x + y * y + z * z);
    return angle < SMALL ? 0.5 : StrictMath.sin(angle / 2.0) / angle;
  }

  private static double halfCos(double x, double y, double z) {
    return StrictMath.cos(Math.sqrt(x * x + y * y + z * z) / 2.0);
  }

  private static void multiply(
      double pw,
      double px,
      double py,
      double pz,
      double qw,
      double qx,
      double qy,
      double qz,
      double[] to,
      int at) {
    double w = pw * qw - px * qx - py * qy - pz * qz;
    double x = pw * qx + px * qw + py * qz - pz * qy;
    double y = pw * qy - px * qz + py * qw + pz * qx;
    double z = pw * qz + px * qy - py * qx + pz * qw;
    double n = 1.0 / Math.sqrt(w * w + x * x + y * y + z * z);
    to[at] = w * n;
    to[at + 1] = x * n;
    to[at + 2] = y * n;
    to[at + 3] = z * n;
  }

  /** Roll of a rotation matrix [rad]. */
  public static double phi(double[] r) {
    return StrictMath.atan2(r[7], r[8]);
  }

  /** Pitch of a rotation matrix [rad]. */
  public static double theta(double[] r) {
    return StrictMath.asin(Math.max(-1.0, Math.min(1.0, -r[6])));
  }

  /** Heading of a rotation matrix [rad, -π…π]. */
  public static double psi(double[] r) {
    return StrictMath.atan2(r[3], r[0]);
  }
}
