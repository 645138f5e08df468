package org.u2sa.device.port;

/**
 * Direction of a compass's front at one time.
 *
 * @param measuredAtMicros time of measurement, or arrival of its bytes [µs of the run's clock]
 * @param headingRad clockwise from north [rad], 0…2π
 * @param isTrue whether relative to true north; otherwise magnetic north
 */
public record Heading(long measuredAtMicros, double headingRad, boolean isTrue)
    implements Device.Reading {
  private static final double TURN_DEG = 360.0;
  private static final double TURN_RAD = 2.0 * Math.PI;

  /** Creates a heading from degrees, wrapping any number of turns. */
  public static Heading ofDegrees(long measuredAtMicros, double headingDeg, boolean isTrue) {
    double turned = headingDeg % TURN_DEG;
    return new Heading(
        measuredAtMicros, Math.toRadians(turned < 0.0 ? turned + TURN_DEG : turned + 0.0), isTrue);
  }

  /** Wraps an angle into 0…2π [rad]. */
  public static double turned(double angleRad) {
    double angle = angleRad % TURN_RAD;
    return angle < 0.0 ? angle + TURN_RAD : angle;
  }
}
