package org.u2sa.planning.search;

/**
 * Cost of proximity to obstacles. Immutable.
 *
 * <p>Space nearer than the radius is impassable. Beyond, the cost per metre falls exponentially
 * from 1 + weight to 1 at the reach, as in the inflation layer of Lu, Hershberger, Smart: Layered
 * Costmaps for Context-Sensitive Navigation, IROS 2014.
 *
 * @param radiusM impassable distance to an obstacle [m]: half the vehicle's width and a clearance
 * @param reachM distance beyond which obstacles add no cost [m]
 * @param weight extra cost per metre at the radius over the open, 0 or more
 */
public record Inflation(double radiusM, double reachM, double weight) {
  private static final double FALLS = 3.0; // e^-3: a twentieth is left at the reach

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

  /** Cost per metre at a distance from an obstacle [m], at least 1; infinite if impassable. */
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
