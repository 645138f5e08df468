package org.u2sa.device.port;

import java.util.Optional;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;

/**
 * Attitude and rates of an IMU at one time. Axes: x forward, y right, z down.
 *
 * @param measuredAtMicros time of measurement, or arrival of its bytes [µs of the run's clock]
 * @param rollRad roll, right side down positive [rad], −π…π
 * @param pitchRad pitch, front up positive [rad], −π/2…π/2
 * @param heading heading, clockwise from north
 * @param xRateRadPerS angular rate about its x axis [rad/s]
 * @param yRateRadPerS angular rate about its y axis [rad/s]
 * @param zRateRadPerS angular rate about its z axis [rad/s]
 * @param specificForce specific force along these axes [m/s²], about -9.8 along z at rest; empty if
 *     not provided
 */
public record Orientation(
    long measuredAtMicros,
    double rollRad,
    double pitchRad,
    Heading heading,
    double xRateRadPerS,
    double yRateRadPerS,
    double zRateRadPerS,
    Optional<Point> specificForce)
    implements Device.Reading {
  private static final double NEARLY_VERTICAL_RAD = Math.toRadians(89.0);

  /** Creates an orientation without specific force. */
  public Orientation(
      long measuredAtMicros,
      double rollRad,
      double pitchRad,
      Heading heading,
      double xRateRadPerS,
      double yRateRadPerS,
      double zRateRadPerS) {
    this(
        measuredAtMicros,
        rollRad,
        pitchRad,
        heading,
        xRateRadPerS,
        yRateRadPerS,
        zRateRadPerS,
        Optional.empty());
  }

  /**
   * Euler angle rates of roll, pitch and heading [rad/s]; empty near gimbal lock, with the front
   * nearly straight up or down.
   */
  public Optional<Point> eulerRates() {
    return Math.abs(pitchRad) < NEARLY_VERTICAL_RAD
        ? Optional.of(
            new Attitude(rollRad, pitchRad, heading.headingRad())
                .eulerRates(Point.of(xRateRadPerS, yRateRadPerS, zRateRadPerS)))
        : Optional.empty();
  }
}
