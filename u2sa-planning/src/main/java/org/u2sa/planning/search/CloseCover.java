package org.u2sa.planning.search;

/**
 * A rectangular vehicle, covered closely by small discs: collision checking to a few centimetres on
 * all four sides. Immutable.
 */
final class CloseCover {
  private final double[] ahead; // of the reference point [m]
  private final double[] aside;
  private final double radiusM;

  /**
   * @param spacingM maximum spacing of discs [m]
   */
  CloseCover(double frontM, double rearM, double widthM, double spacingM) {
    double length = frontM + rearM;
    ahead = middles(-rearM, length, spacingM);
    aside = middles(-0.5 * widthM, widthM, spacingM);
    radiusM = Math.hypot(0.5 * length / ahead.length, 0.5 * widthM / aside.length);
  }

  /** Centres of equal parts that are no longer than the spacing. */
  private static double[] middles(double from, double length, double spacingM) {
    int count = Math.max(1, (int) Math.ceil(length / spacingM));
    double[] middles = new double[count];
    for (int i = 0; i < count; i++) {
      middles[i] = from + length * (i + 0.5) / count;
    }
    return middles;
  }

  /** Distance between the discs and the nearest occupied cell [m]; negative if they touch. */
  double clearanceM(CostGrid grid, double northM, double eastM, double headingRad) {
    double cos = Math.cos(headingRad);
    double sin = Math.sin(headingRad);
    double least = Double.POSITIVE_INFINITY;
    for (double forward : ahead) {
      for (double right : aside) {
        double north = northM + forward * cos - right * sin;
        double east = eastM + forward * sin + right * cos;
        least = Math.min(least, grid.distanceM(north, east));
      }
    }
    return least - radiusM;
  }
}
