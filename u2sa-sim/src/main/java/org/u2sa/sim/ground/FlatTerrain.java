package org.u2sa.sim.ground;

/** Level ground. */
enum FlatTerrain implements Terrain {
  /** The only one. */
  FLAT;

  @Override
  public double heightM(double eastM, double northM) {
    return 0.0;
  }

  @Override
  public double riseEast(double eastM, double northM) {
    return 0.0;
  }

  @Override
  public double riseNorth(double eastM, double northM) {
    return 0.0;
  }
}
