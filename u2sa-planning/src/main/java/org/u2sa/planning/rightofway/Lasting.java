package org.u2sa.planning.rightofway;

/** Debounces a condition, because tracks are noisy. */
final class Lasting {
  private final double minimumS;
  private double sinceS = Double.NaN;

  Lasting(double minimumS) {
    this.minimumS = minimumS;
  }

  /** Whether the condition has held without interruption for the minimum time. */
  boolean lasts(boolean holds, double nowS) {
    if (!holds) {
      sinceS = Double.NaN;
    } else if (Double.isNaN(sinceS)) {
      sinceS = nowS;
    }
    return holds && nowS - sinceS >= minimumS;
  }
}
