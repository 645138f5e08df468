package org.u2sa.sim.ground;

/**
 * An inclined plane through the local plane's origin.
 *
 * @param east height gained for each metre to the east [1]
 * @param north height gained for each metre to the north [1]
 */
record EvenSlope(double east, double north) implements Terrain {
  @Override
  public double heightM(double eastM, double northM) {
    return east * eastM + north * northM;
  }

  @Override
  public double riseEast(double eastM, double northM) {
    return east;
  }

  @Override
  public double riseNorth(double eastM, double northM) {
    return north;
  }
}
