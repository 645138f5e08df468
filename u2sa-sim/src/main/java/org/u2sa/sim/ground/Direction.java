package org.u2sa.sim.ground;

/**
 * Sine and cosine of a heading. A vehicle asks for the same one several times in a tick, so they
 * are computed only when it has turned. For one thread.
 */
final class Direction {
  private double headingRad = Double.NaN;
  private double sin;
  private double cos;

  /** Takes a heading [rad]. */
  void turn(double newHeadingRad) {
    if (Double.compare(newHeadingRad, headingRad) != 0) { // which tells 0 from −0
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
