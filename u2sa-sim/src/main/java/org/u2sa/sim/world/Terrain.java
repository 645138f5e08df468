package org.u2sa.sim.world;

import org.u2sa.sim.motion.Arguments;

/**
 * Ground height at each point of the world's plane. Slopes are assumed gentle: distances along them
 * equal their horizontal projection, 1.5 % too short at 10°.
 */
public interface Terrain {
  /** Shortest step along a ray [m]. */
  double MIN_STEP_M = 1e-4;

  /** Accuracy of ray distances [m]. */
  double EXACT_M = 1e-9;

  /** Height above the local plane [m]. */
  double heightM(double eastM, double northM);

  /** Slope toward east [1]. */
  double riseEast(double eastM, double northM);

  /** Slope toward north [1]. */
  double riseNorth(double eastM, double northM);

  /** The same terrain as a ground vehicle's wheels meet it: without edges of its slopes. */
  default Terrain underWheels() {
    return this;
  }

  /** Upper bound of the slope [1]. */
  double steepest();

  /** Upper bound of the height [m]; infinite if unbounded. */
  double highestM();

  /**
   * Distance along a ray to the ground [m]; 0 if it starts below, infinite if there is no hit
   * within the range.
   *
   * <p>Each step is as long as the steepest ground allows without tunnelling, so only crests that
   * the ray cuts by less than 0.1 mm are missed.
   */
  default double distanceM(Ray ray, double rangeM) {
    double closing =
        steepest() * Math.hypot(ray.dx(), ray.dy()) - ray.dz(); // maximum closing rate [m/m]
    double above = aboveM(ray, 0.0);
    double before = 0.0;
    double after = 0.0;
    while (above > 0.0) {
      boolean over = ray.dz() >= 0.0 && ray.z() + after * ray.dz() > highestM();
      if (over || closing <= 0.0 || after >= rangeM) {
        return Double.POSITIVE_INFINITY;
      }
      before = after;
      after = Math.min(rangeM, after + Math.max(MIN_STEP_M, above / closing));
      above = aboveM(ray, after);
    }
    while (after - before > EXACT_M) {
      double middle = 0.5 * (before + after);
      if (aboveM(ray, middle) > 0.0) {
        before = middle;
      } else {
        after = middle;
      }
    }
    return before;
  }

  private double aboveM(Ray ray, double along) {
    return ray.z()
        + along * ray.dz()
        - heightM(ray.x() + along * ray.dx(), ray.y() + along * ray.dy());
  }

  /** Level ground. */
  static Terrain flat() {
    return Plane.LEVEL;
  }

  /**
   * A uniform slope.
   *
   * @param slopeRad steepness, 0…0.5 [rad]
   * @param towardsRad uphill direction, clockwise from north [rad]
   * @throws IllegalArgumentException if the slope is outside its range
   */
  static Terrain slope(double slopeRad, double towardsRad) {
    Arguments.requireInside("slope", slopeRad, 0.0, 0.5);
    Arguments.requireFinite("direction of the slope", towardsRad);
    double rise = StrictMath.tan(slopeRad);
    return new Plane(rise * StrictMath.sin(towardsRad), rise * StrictMath.cos(towardsRad));
  }

  /**
   * A round hill on level ground with a cosine profile, steepest halfway up.
   *
   * @param eastM east coordinate of its top [m]
   * @param northM north coordinate of its top [m]
   * @param radiusM radius of its foot [m]
   * @param steepestRad slope halfway up, 0…0.5 [rad]
   * @throws IllegalArgumentException if a value is outside its range
   */
  static Terrain hill(double eastM, double northM, double radiusM, double steepestRad) {
    Arguments.requireFinite("hill east", eastM);
    Arguments.requireFinite("hill north", northM);
    Arguments.requirePositive("radius of the hill", radiusM);
    Arguments.requireInside("slope of the hill", steepestRad, 0.0, 0.5);
    return new Hill(eastM, northM, radiusM, StrictMath.tan(steepestRad));
  }

  /**
   * A plane through the origin.
   *
   * @param riseEast slope toward east [1]
   * @param riseNorth slope toward north [1]
   */
  record Plane(double riseEast, double riseNorth) implements Terrain {
    private static final Plane LEVEL = new Plane(0.0, 0.0);

    @Override
    public double heightM(double eastM, double northM) {
      return riseEast * eastM + riseNorth * northM;
    }

    @Override
    public double riseEast(double eastM, double northM) {
      return riseEast;
    }

    @Override
    public double riseNorth(double eastM, double northM) {
      return riseNorth;
    }

    @Override
    public double steepest() {
      return StrictMath.hypot(riseEast, riseNorth);
    }

    @Override
    public double highestM() {
      return steepest() == 0.0 ? 0.0 : Double.POSITIVE_INFINITY;
    }

    @Override
    public double distanceM(Ray ray, double rangeM) {
      double above = ray.z() - heightM(ray.x(), ray.y());
      double closing = heightM(ray.dx(), ray.dy()) - ray.dz();
      double distance = above <= 0.0 ? 0.0 : closing > 0.0 ? above / closing : rangeM + 1.0;
      return distance <= rangeM ? distance : Double.POSITIVE_INFINITY;
    }
  }

  /**
   * A hill with height H (1 + cos(π r / R)) / 2 at distance r from its top.
   *
   * @param eastM east coordinate of the top [m]
   * @param northM north coordinate of the top [m]
   * @param radiusM R, radius of the foot [m]
   * @param steepest slope halfway up, π H / 2 R [1]
   */
  record Hill(double eastM, double northM, double radiusM, double steepest) implements Terrain {
    @Override
    public double heightM(double east, double north) {
      return 0.5 * highestM() * (1.0 + StrictMath.cos(angle(east, north)));
    }

    @Override
    public double riseEast(double east, double north) {
      return rise(east, north, east - eastM);
    }

    @Override
    public double riseNorth(double east, double north) {
      return rise(east, north, north - northM);
    }

    @Override
    public double highestM() {
      return 2.0 * radiusM * steepest / StrictMath.PI;
    }

    private double rise(double east, double north, double part) {
      double distance = distanceM(east, north);
      return distance == 0.0
          ? 0.0
          : -steepest * StrictMath.sin(angle(east, north)) * part / distance;
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
}
