package org.u2sa.drivers.gps;

/** Plausibility limits of receivers on or near the earth; NaN, for absent values, passes. */
final class Plausible {
  private static final double FASTEST_MPS = 1_000.0;
  private static final double LOWEST_M = -1_000.0;
  private static final double HIGHEST_M = 100_000.0;

  private Plausible() {}

  static double latitudeDeg(double value) {
    return inRange("latitude", value, -90.0, 90.0);
  }

  static double longitudeDeg(double value) {
    return inRange("longitude", value, -180.0, 180.0);
  }

  static double altitudeM(double value) {
    return inRange("altitude", value, LOWEST_M, HIGHEST_M);
  }

  static double velocityMps(double value) {
    return inRange("velocity", value, -FASTEST_MPS, FASTEST_MPS);
  }

  /**
   * @throws IllegalArgumentException naming the value and its range, if outside
   */
  static double inRange(String what, double value, double lowest, double highest) {
    if (value < lowest || value > highest) {
      throw new IllegalArgumentException(
          what + " " + value + " is outside " + lowest + "…" + highest);
    }
    return value;
  }
}
