package org.u2sa.world.scanmap;

/**
 * Position and orientation in the plane, in any right-handed pair of axes.
 *
 * @param x position along the first axis [m]
 * @param y position along the second axis [m]
 * @param theta angle of the vehicle's nose, from the first axis to the second [rad]
 */
record Pose2(double x, double y, double theta) {
  static final Pose2 ORIGIN = new Pose2(0.0, 0.0, 0.0);

  /** Pose given relative to this one, expressed in this one's axes. */
  Pose2 times(Pose2 relative) {
    double c = StrictMath.cos(theta);
    double s = StrictMath.sin(theta);
    return new Pose2(
        x + c * relative.x - s * relative.y,
        y + s * relative.x + c * relative.y,
        wrapped(theta + relative.theta));
  }

  /** This pose relative to another, so that {@code other.times(this.from(other))} is this. */
  Pose2 from(Pose2 other) {
    double c = StrictMath.cos(other.theta);
    double s = StrictMath.sin(other.theta);
    double dx = x - other.x;
    double dy = y - other.y;
    return new Pose2(c * dx + s * dy, c * dy - s * dx, wrapped(theta - other.theta));
  }

  /** Distance between the positions [m]. */
  double distance(Pose2 other) {
    return Math.hypot(x - other.x, y - other.y);
  }

  /** Normalises an angle to ±π. */
  static double wrapped(double angle) {
    return Math.IEEEremainder(angle, 2.0 * Math.PI);
  }
}
