package org.u2sa.device;

import java.util.Optional;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;

/**
 * Attitude and rates of an IMU at one moment. Axes: x forward, y right, z down.
 *
 * @param measuredAtMicros when it was measured, or its bytes arrived [µs of the run's clock]
 * @param rollRad right side down positive [rad], −π…π
 * @param pitchRad front up positive [rad], −π/2…π/2
 * @param heading clockwise from north
 * @param xRateRadPerS turning about its x axis [rad/s]
 * @param yRateRadPerS turning about its y axis [rad/s]
 * @param zRateRadPerS turning about its z axis [rad/s]
 * @param specificForce what the accelerometers felt along these axes [m/s²], about -9.8 along z at
 *     rest; empty if the unit does not say
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

  /** Of a unit that does not say what its accelerometers felt. */
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
   * Rates of roll, pitch and heading [rad/s]; empty where the front points nearly straight up or
   * down, as roll and heading then are one and the same.
   */
  public Optional<Point> eulerRates() {
    return Math.abs(pitchRad) < NEARLY_VERTICAL_RAD
        ? Optional.of(
            new Attitude(rollRad, pitchRad, heading.headingRad())
                .eulerRates(Point.of(xRateRadPerS, yRateRadPerS, zRateRadPerS)))
        : Optional.empty();
  }
}
