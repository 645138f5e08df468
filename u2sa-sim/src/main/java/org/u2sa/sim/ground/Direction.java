package org.u2sa.sim.ground;

/**
 * Cached sine and cosine of a heading, recomputed only when the heading changes. Not thread-safe.
 */
final class Direction {
  private double headingRad = Double.NaN;
  private double sin;
  private double cos;

  /** Sets the heading [rad]. */
  void turn(double newHeadingRad) {
    if (Double.compare(newHeadingRad, headingRad) != 0) { // distinguishes 0 from −0
      headingRad = newHeadingRad;
      sin = StrictMath.sin(newHeadingRad);
      cos = StrictMath.cos(newHeadingRad);
    }
  }

  double sin() {
    return sin;
  }

  double cos() {
    return cos;
  }
}
