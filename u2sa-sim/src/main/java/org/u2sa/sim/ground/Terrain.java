package org.u2sa.sim.ground;

import org.u2sa.sim.motion.Arguments;

/**
 * How high the ground is at each place of the local plane. Slopes are gentle: ways along them are
 * taken as long as on the map, which is 1.5 % too short at 10°.
 */
public interface Terrain {
  /** Height above the local plane [m]. */
  double heightM(double eastM, double northM);

  /** Height gained for each metre to the east [1]. */
  double riseEast(double eastM, double northM);

  /** Height gained for each metre to the north [1]. */
  double riseNorth(double eastM, double northM);

  /** Level ground. */
  static Terrain flat() {
    return FlatTerrain.FLAT;
  }

  /**
   * Ground that rises evenly.
   *
   * @param slopeRad steepness, 0…0.5 [rad]
   * @param towardsRad direction in which it rises, clockwise from north [rad]
   * @throws IllegalArgumentException if the slope is outside its range
   */
  static Terrain slope(double slopeRad, double towardsRad) {
    Arguments.requireInside("slope", slopeRad, 0.0, 0.5);
    Arguments.requireFinite("direction of the slope", towardsRad);
    double rise = StrictMath.tan(slopeRad);
    return new EvenSlope(rise * StrictMath.sin(towardsRad), rise * StrictMath.cos(towardsRad));
  }

  /**
   * A round hill on level ground, a cosine from foot to foot: steepest half way up.
   *
   * @param eastM of its top [m]
   * @param northM of its top [m]
   * @param radiusM of its foot [m]
   * @param steepestRad slope half way up, 0…0.5 [rad]
   * @throws IllegalArgumentException if a value is outside its range
   */
  static Terrain hill(double eastM, double northM, double radiusM, double steepestRad) {
    Arguments.requireFinite("hill east", eastM);
    Arguments.requireFinite("hill north", northM);
    Arguments.requirePositive("radius of the hill", radiusM);
    Arguments.requireInside("slope of the hill", steepestRad, 0.0, 0.5);
    return new RoundHill(eastM, northM, radiusM, StrictMath.tan(steepestRad));
  }
}
