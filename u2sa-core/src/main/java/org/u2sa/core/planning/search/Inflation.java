package org.u2sa.core.planning.search;

/**
 * What nearness to obstacles costs. Immutable.
 *
 * <p>Nearer than the radius no way leads. From there on the cost of a metre falls exponentially
 * from 1 + weight to 1 at the reach, as in the inflation layer of Lu, Hershberger, Smart: Layered
 * Costmaps for Context-Sensitive Navigation, IROS 2014.
 *
 * @param radiusM nearer to an obstacle no way leads [m]: half the vehicle's width and a clearance
 * @param reachM farther from an obstacle it costs nothing [m]
 * @param weight what a metre at the radius costs more than one in the open, 0 or more
 */
public record Inflation(double radiusM, double reachM, double weight) {
  private static final double FALLS = 3.0; // e^-3: a twentieth is left at the reach

  /** Checks the distances. */
  public Inflation {
    if (!(radiusM >= 0.0) || !(reachM > radiusM) || !(weight >= 0.0)) {
      throw new IllegalArgumentException(
          "inflation by "
              + radiusM
              + " m to "
              + reachM
              + " m with weight "
              + weight
              + ": expected 0 <= radius < reach, weight >= 0");
    }
  }

  /**
   * Cost of a metre so far from the nearest obstacle [m], at least 1; infinite where none leads.
   */
  double cost(double distanceM) {
    if (distanceM < radiusM) {
      return Double.POSITIVE_INFINITY;
    }
    if (distanceM >= reachM) {
      return 1.0;
    }
    return 1.0 + weight * Math.exp(-FALLS * (distanceM - radiusM) / (reachM - radiusM));
  }
}
