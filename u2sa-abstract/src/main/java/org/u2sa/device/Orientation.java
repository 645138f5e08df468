package org.u2sa.device;

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
 */
public record Orientation(
    long measuredAtMicros,
    double rollRad,
    double pitchRad,
    Heading heading,
    double xRateRadPerS,
    double yRateRadPerS,
    double zRateRadPerS)
    implements Device.Reading {
  private static final double LEAST_COSINE = 1e-6; // with the front straight up the rates are lost

  /** Rate of the roll angle [rad/s]. */
  public double rollRateRadPerS() {
    // φ̇ = p + tan θ (q sin φ + r cos φ) (Stevens & Lewis, 2nd ed., eq. 1.3-22a)
    return xRateRadPerS + Math.sin(pitchRad) * headingRateRadPerS();
  }

  /** Rate of the pitch angle [rad/s]. */
  public double pitchRateRadPerS() {
    return yRateRadPerS * Math.cos(rollRad) - zRateRadPerS * Math.sin(rollRad); // eq. 1.3-22a
  }

  /** Rate of the heading [rad/s]. */
  public double headingRateRadPerS() {
    double cosine = Math.cos(pitchRad);
    double safe = Math.abs(cosine) < LEAST_COSINE ? Math.copySign(LEAST_COSINE, cosine) : cosine;
    return (yRateRadPerS * Math.sin(rollRad) + zRateRadPerS * Math.cos(rollRad)) / safe;
  }
}
