package org.u2sa.sim.world;

/**
 * Terrain as a ground vehicle meets it: wheels 0.4 m apart round off the edges between the plane
 * pieces of a height map. On the bare edges, the vehicle would turn and climb in an instant, which
 * its inertial sensors would see as a blow or not at all.
 *
 * <p>Slopes are those between wheels, averaged over three tracks by Simpson's rule, as are heights.
 */
record RoundedTerrain(Terrain bare) implements Terrain {
  private static final double HALF_M = 0.2; // of the wheelbase

  private interface Profile {
    double at(double asideM);
  }

  /** Mean across the vehicle. */
  private static double mean(Profile profile) {
    return (profile.at(-HALF_M) + 4.0 * profile.at(0.0) + profile.at(HALF_M)) / 6.0;
  }

  @Override
  public double heightM(double eastM, double northM) {
    return mean(north -> mean(east -> bare.heightM(eastM + east, northM + north)));
  }

  @Override
  public double riseEast(double eastM, double northM) {
    return mean(
        north ->
            (bare.heightM(eastM + HALF_M, northM + north)
                    - bare.heightM(eastM - HALF_M, northM + north))
                / (2.0 * HALF_M));
  }

  @Override
  public double riseNorth(double eastM, double northM) {
    return mean(
        east ->
            (bare.heightM(eastM + east, northM + HALF_M)
                    - bare.heightM(eastM + east, northM - HALF_M))
                / (2.0 * HALF_M));
  }

  @Override
  public double steepest() {
    return bare.steepest();
  }

  @Override
  public double highestM() {
    return bare.highestM();
  }
}
