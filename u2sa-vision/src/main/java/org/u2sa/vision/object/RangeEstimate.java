package org.u2sa.vision.object;

/**
 * A distance with its uncertainty [m].
 *
 * @param sigma standard deviation; infinite if unknown
 */
record RangeEstimate(double range, double sigma) {
  private static final double DISAGREE = 3.0; // in standard deviations of the difference

  static final RangeEstimate UNKNOWN = new RangeEstimate(0.0, Double.POSITIVE_INFINITY);

  boolean isKnown() {
    return sigma < Double.POSITIVE_INFINITY;
  }

  /** Whether both are consistent with one object. */
  boolean agreesWith(RangeEstimate other) {
    return !isKnown()
        || !other.isKnown()
        || Math.abs(range - other.range) <= DISAGREE * Math.hypot(sigma, other.sigma);
  }

  /** Inverse-variance fusion; if they disagree, this one, less certain by half the difference. */
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
