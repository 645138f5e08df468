package org.u2sa.planning.rightofway;

/** Angles of courses and bearings. */
final class Angles {
  private Angles() {}

  /** Wraps an angle to −π…π. */
  static double wrapped(double angleRad) {
    return Math.IEEEremainder(angleRad, 2.0 * Math.PI);
  }

  /** Whole degrees in nautical notation, clockwise from north, 000 to 359. */
  static long degrees(double courseRad) {
    return Math.floorMod(Math.round(Math.toDegrees(courseRad)), 360L);
  }
}
