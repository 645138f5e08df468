package org.u2sa.planning.search;

import java.util.function.DoubleUnaryOperator;

/**
 * A rectangular vehicle, covered by discs along its axis, so that a few distances suffice for
 * collision checking (Ziegler, Stiller: Fast Collision Checking for Intelligent Vehicle Motion
 * Planning, IV 2010). Immutable.
 */
public final class BodyDiscs {
  private static final double[] AXIS = {0.0};

  private static final double EDGE_M = 0.25; // spacing of points along the rear

  private final double frontM;
  private final double rearM;
  private final double halfWidthM;
  private final double[] ahead; // ahead of the reference point [m]
  private final double radiusM;
  private final double circleM;
  private final CloseCover close; // null if only the discs along the axis are used

  /**
   * @param frontM from the reference point to the front [m]
   * @param rearM from the reference point to the rear [m]
   * @param widthM width [m], above 0
   */
  public BodyDiscs(double frontM, double rearM, double widthM) {
    this(frontM, rearM, widthM, null);
  }

  private BodyDiscs(double frontM, double rearM, double widthM, CloseCover close) {
    this.close = close;
    this.frontM = frontM;
    this.rearM = rearM;
    halfWidthM = 0.5 * widthM;
    double length = frontM + rearM;
    int count = Math.max(1, (int) Math.ceil(length / widthM));
    ahead = new double[count];
    for (int i = 0; i < count; i++) {
      ahead[i] = -rearM + length * (i + 0.5) / count;
    }
    radiusM = Math.hypot(0.5 * length / count, 0.5 * widthM);
    circleM = Math.hypot(Math.max(Math.abs(frontM), Math.abs(rearM)), 0.5 * widthM);
  }

  /**
   * Creates a cover that is exact to a few centimetres near obstacles, for passages barely wider
   * than the vehicle.
   *
   * @param spacingM spacing of the small discs that cover it [m]
   */
  public static BodyDiscs closely(double frontM, double rearM, double widthM, double spacingM) {
    CloseCover close = new CloseCover(frontM, rearM, widthM, spacingM);
    return new BodyDiscs(frontM, rearM, widthM, close);
  }

  public int count() {
    return ahead.length;
  }

  /** Distance of a disc ahead of the reference point [m]. */
  public double aheadM(int disc) {
    return ahead[disc];
  }

  /** Radius of each disc [m]. */
  public double radiusM() {
    return radiusM;
  }

  /** Radius of the circle around the reference point that the vehicle sweeps as it turns [m]. */
  public double circleM() {
    return circleM;
  }

  /** Half of its width [m]. */
  public double halfWidthM() {
    return halfWidthM;
  }

  /**
   * Whether the vehicle covers a point.
   *
   * @param forwardM forward of the reference point [m]
   * @param rightM right of it [m]
   * @param marginM distance from the vehicle that counts as covered [m]
   */
  boolean covers(double forwardM, double rightM, double marginM) {
    return forwardM <= frontM + marginM
        && forwardM >= -rearM - marginM
        && Math.abs(rightM) <= halfWidthM + marginM;
  }

  /** Whether a part of the vehicle's rear is above ground that was neither seen nor passed. */
  public boolean isRearUnseen(CostGrid grid, double northM, double eastM, double headingRad) {
    double cos = Math.cos(headingRad);
    double sin = Math.sin(headingRad);
    int parts = Math.max(1, (int) Math.ceil(2.0 * halfWidthM / EDGE_M));
    for (int i = 0; i <= parts; i++) {
      double right = halfWidthM * (2.0 * i / parts - 1.0);
      double north = northM - rearM * cos - right * sin;
      double east = eastM - rearM * sin + right * cos;
      if (grid.isUnseen(north, east)) {
        return true;
      }
    }
    return false;
  }

  /** Clearance of the discs [m], possibly underestimated above a cell; negative if they touch. */
  public double clearanceM(CostGrid grid, double northM, double eastM, double headingRad) {
    return clearanceM(grid, northM, eastM, headingRad, grid.frame().cellM());
  }

  /**
   * Distance between the discs and the nearest occupied cell [m]; negative if they touch.
   *
   * @param enoughM distance above which the result may be underestimated [m]
   */
  public double clearanceM(
      CostGrid grid, double northM, double eastM, double headingRad, double enoughM) {
    if (close != null) {
      double aroundM = grid.distanceM(northM, eastM) - circleM; // regardless of heading
      return aroundM > enoughM ? aroundM : close.clearanceM(grid, northM, eastM, headingRad);
    }
    double cos = Math.cos(headingRad);
    double sin = Math.sin(headingRad);
    double least = Double.POSITIVE_INFINITY;
    for (double along : ahead) {
      least = Math.min(least, grid.distanceM(northM + along * cos, eastM + along * sin));
    }
    return least - radiusM;
  }

  /** Fraction of discs whose centre is on an occupied cell: there, the clearance is the same. */
  public double shareInside(CostGrid grid, double northM, double eastM, double headingRad) {
    return mean(grid, northM, eastM, headingRad, away -> away > 0.0 ? 0.0 : 1.0);
  }

  /** Mean distance of the discs' centres to the nearest occupied cell [m], up to the reach. */
  public double meanDistanceM(CostGrid grid, double northM, double eastM, double headingRad) {
    return mean(grid, northM, eastM, headingRad, away -> away);
  }

  private double mean(
      CostGrid grid,
      double northM,
      double eastM,
      double headingRad,
      DoubleUnaryOperator ofDistance) {
    double cos = Math.cos(headingRad);
    double sin = Math.sin(headingRad);
    double[] forwards = close == null ? ahead : close.ahead;
    double[] rights = close == null ? AXIS : close.aside;
    double sum = 0.0;
    for (double forward : forwards) {
      for (double right : rights) {
        double north = northM + forward * cos - right * sin;
        double east = eastM + forward * sin + right * cos;
        sum += ofDistance.applyAsDouble(grid.distanceM(north, east));
      }
    }
    return sum / (forwards.length * rights.length);
  }

  /** A rectangular vehicle covered closely by small discs: exact to a few centimetres all round. */
  static final class CloseCover {
    private final double[] ahead; // ahead of the reference point [m]
    private final double[] aside;
    private final double radiusM;

    CloseCover(double frontM, double rearM, double widthM, double spacingM) {
      double length = frontM + rearM;
      ahead = middles(-rearM, length, spacingM);
      aside = middles(-0.5 * widthM, widthM, spacingM);
      radiusM = Math.hypot(0.5 * length / ahead.length, 0.5 * widthM / aside.length);
    }

    /** Centres of equal parts not longer than the spacing. */
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
}
