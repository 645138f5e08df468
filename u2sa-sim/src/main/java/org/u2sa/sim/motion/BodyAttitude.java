package org.u2sa.sim.motion;

/** Attitude from body (forward, right, down) to NED: the rotation matrix of a unit quaternion. */
public final class BodyAttitude {
  private double xn;
  private double xe;
  private double xd;
  private double yn;
  private double ye;
  private double yd;
  private double zn;
  private double ze;
  private double zd;

  /**
   * Sets the attitude from a quaternion body → NED, scalar first, of any non-zero length (Stevens
   * and Lewis, 2nd ed., eq. 1.3-33).
   */
  public void set(double q0, double q1, double q2, double q3) {
    double scale = 2.0 / (q0 * q0 + q1 * q1 + q2 * q2 + q3 * q3);
    xn = 1.0 - scale * (q2 * q2 + q3 * q3);
    xe = scale * (q1 * q2 + q0 * q3);
    xd = scale * (q1 * q3 - q0 * q2);
    yn = scale * (q1 * q2 - q0 * q3);
    ye = 1.0 - scale * (q1 * q1 + q3 * q3);
    yd = scale * (q2 * q3 + q0 * q1);
    zn = scale * (q1 * q3 + q0 * q2);
    ze = scale * (q2 * q3 - q0 * q1);
    zd = 1.0 - scale * (q1 * q1 + q2 * q2);
  }

  /** North component of a vector in body axes. */
  public double north(double x, double y, double z) {
    return xn * x + yn * y + zn * z;
  }

  /** East component of a vector in body axes. */
  public double east(double x, double y, double z) {
    return xe * x + ye * y + ze * z;
  }

  /** Down component of a vector in body axes. */
  public double down(double x, double y, double z) {
    return xd * x + yd * y + zd * z;
  }

  /** Forward component of a vector in north, east, down. */
  public double forward(double n, double e, double d) {
    return xn * n + xe * e + xd * d;
  }

  /** Right component of a vector in north, east, down. */
  public double right(double n, double e, double d) {
    return yn * n + ye * e + yd * d;
  }

  /** Downward component, in body axes, of a vector in north, east, down. */
  public double below(double n, double e, double d) {
    return zn * n + ze * e + zd * d;
  }

  /** Roll, right wing down positive [rad]. */
  public double rollRad() {
    return StrictMath.atan2(yd, zd);
  }

  /** Pitch, nose up positive [rad]. */
  public double pitchRad() {
    return StrictMath.asin(Math.max(-1.0, Math.min(1.0, -xd)));
  }

  /** True heading, 0…2π [rad]. */
  public double headingRad() {
    double heading = StrictMath.atan2(xe, xn);
    return heading < 0.0 ? heading + 2.0 * Math.PI : heading;
  }

  /** Writes the quaternion of roll, pitch and heading [rad] into a state at an index. */
  public static void write(double[] state, int index, double roll, double pitch, double heading) {
    double cr = StrictMath.cos(roll / 2);
    double sr = StrictMath.sin(roll / 2);
    double cp = StrictMath.cos(pitch / 2);
    double sp = StrictMath.sin(pitch / 2);
    double ch = StrictMath.cos(heading / 2);
    double sh = StrictMath.sin(heading / 2);
    state[index] = cr * cp * ch + sr * sp * sh;
    state[index + 1] = sr * cp * ch - cr * sp * sh;
    state[index + 2] = cr * sp * ch + sr * cp * sh;
    state[index + 3] = cr * cp * sh - sr * sp * ch;
  }
}
