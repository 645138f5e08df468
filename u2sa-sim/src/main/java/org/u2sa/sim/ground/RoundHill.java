package org.u2sa.sim.ground;

/**
 * A hill whose height is a cosine of the distance from its top, H (1 + cos(π r / R)) / 2.
 *
 * @param eastM of the top [m]
 * @param northM of the top [m]
 * @param radiusM R, of the foot [m]
 * @param steepest rise half way up, π H / 2 R [1]
 */
record RoundHill(double eastM, double northM, double radiusM, double steepest) implements Terrain {
  @Override
  public double heightM(double east, double north) {
    double angle = angle(east, north);
    return radiusM * steepest / StrictMath.PI * (1.0 + StrictMath.cos(angle));
  }

  @Override
  public double riseEast(double east, double north) {
    return rise(east, north, east - eastM);
  }

  @Override
  public double riseNorth(double east, double north) {
    return rise(east, north, north - northM);
  }

  private double rise(double east, double north, double part) {
    double distance = distanceM(east, north);
    return distance == 0.0 ? 0.0 : -steepest * StrictMath.sin(angle(east, north)) * part / distance;
  }

  private double angle(double east, double north) {
    return StrictMath.PI * Math.min(1.0, distanceM(east, north) / radiusM);
  }

  private double distanceM(double east, double north) {
    double toEast = east - eastM;
    double toNorth = north - northM;
    return StrictMath.sqrt(toEast * toEast + toNorth * toNorth);
  }
}
