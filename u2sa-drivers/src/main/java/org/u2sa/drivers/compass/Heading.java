package org.u2sa.drivers.compass;

/**
 * Where a compass's front pointed at one moment.
 *
 * @param measuredAtMicros when the bytes came [µs of the run's clock]
 * @param headingRad clockwise from north [rad], 0…2π
 * @param isTrue whether north is true north; otherwise magnetic north
 */
public record Heading(long measuredAtMicros, double headingRad, boolean isTrue) {
  private static final double TURN_DEG = 360.0;

  /** A heading in degrees; any number of turns. */
  static Heading ofDegrees(long measuredAtMicros, double headingDeg, boolean isTrue) {
    double turned = headingDeg % TURN_DEG;
    return new Heading(
        measuredAtMicros, Math.toRadians(turned < 0.0 ? turned + TURN_DEG : turned), isTrue);
  }
}
