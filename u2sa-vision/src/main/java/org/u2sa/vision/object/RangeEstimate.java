package org.u2sa.vision.object;

/**
 * A distance and how well it is known [m].
 *
 * @param sigma standard deviation; infinite if nothing is known
 */
record RangeEstimate(double range, double sigma) {
  private static final double DISAGREE = 3.0; // standard deviations between two estimates

  static final RangeEstimate UNKNOWN = new RangeEstimate(0.0, Double.POSITIVE_INFINITY);

  boolean isKnown() {
    return sigma < Double.POSITIVE_INFINITY;
  }

  /** Whether both can be of the same thing. */
  boolean agreesWith(RangeEstimate other) {
    return !isKnown()
        || !other.isKnown()
        || Math.abs(range - other.range) <= DISAGREE * Math.hypot(sigma, other.sigma);
  }

  /**
   * Both together, weighted by how well they are known; if they disagree, this one, and by half the
   * difference less certain.
   */
  RangeEstimate with(RangeEstimate other) {
    if (!other.isKnown()) {
      return this;
    }
    if (!isKnown()) {
      return other;
    }
    if (!agreesWith(other)) {
      return new RangeEstimate(range, Math.hypot(sigma, 0.5 * (range - other.range)));
    }
    double mine = 1.0 / (sigma * sigma);
    double others = 1.0 / (other.sigma * other.sigma);
    return new RangeEstimate(
        (mine * range + others * other.range) / (mine + others), Math.sqrt(1.0 / (mine + others)));
  }
}
