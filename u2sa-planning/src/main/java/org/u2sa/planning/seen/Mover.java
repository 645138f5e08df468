package org.u2sa.planning.seen;

/**
 * Traffic: a disc that moves on the planning plane, or a sphere in the air, as far as known.
 * Immutable.
 *
 * @param name UID of the object
 * @param seenMicros time of the first point [µs]
 * @param stepS time between points [s]; 0 if only the first has a time
 * @param norths north coordinates of its centre at each step [m], at least one
 * @param easts east coordinates of its centre at each step [m], same number
 * @param northMps northward velocity after the last point [m/s]
 * @param eastMps eastward velocity after the last point [m/s]
 * @param radiusM clearance radius around its centre [m]
 * @param sigmaM standard deviation of its position [m]; 0 if unknown
 * @param sigmaMps standard deviation of its velocity [m/s]; 0 if unknown
 * @param heights its altitudes
 */
public record Mover(
    String name,
    long seenMicros,
    double stepS,
    double[] norths,
    double[] easts,
    double northMps,
    double eastMps,
    double radiusM,
    double sigmaM,
    double sigmaMps,
    Heights heights) {
  private static final double MICROS = 1.0e-6;

  /** Below this speed an object counts as stationary [m/s]. */
  private static final double STANDS_MPS = 0.05;

  private static final double HOVERS_MPS = 1.0; // error of a velocity by satellite navigation

  private static final double CLIMBS_MPS = 0.5; // less may be an error of its altitude

  /**
   * Altitudes of traffic.
   *
   * @param downs down coordinates of its centre at each step [m], as many as north coordinates
   * @param downMps downward velocity after the last point [m/s]
   * @param halfM clearance above and below its centre [m]; infinite: it cannot be passed over
   */
  public record Heights(double[] downs, double downMps, double halfM) {
    static Heights any(int points) {
      return new Heights(new double[points], 0.0, Double.POSITIVE_INFINITY);
    }
  }

  /** A mover of unknown accuracy that cannot be passed over. */
  public Mover(
      String name,
      long seenMicros,
      double stepS,
      double[] norths,
      double[] easts,
      double northMps,
      double eastMps,
      double radiusM) {
    this(
        name,
        seenMicros,
        stepS,
        norths,
        easts,
        northMps,
        eastMps,
        radiusM,
        0.0,
        0.0,
        Heights.any(norths.length));
  }

  boolean stands() {
    return Math.hypot(northMps, eastMps) < STANDS_MPS;
  }

  /**
   * Whether it can be passed over, and may hover or climb and descend in place: it may stay where
   * it is at any time, and its measured velocity shows that only seconds later.
   */
  boolean mayStay() {
    return Math.hypot(northMps, eastMps) < HOVERS_MPS && heights.halfM < Double.POSITIVE_INFINITY;
  }

  /** Whether it climbs or descends, and can be passed over. */
  boolean climbs() {
    return Math.abs(heights.downMps) >= CLIMBS_MPS && heights.halfM < Double.POSITIVE_INFINITY;
  }

  /** Copy with another velocity from its current position, at its altitude. */
  Mover moving(double newNorthMps, double newEastMps) {
    return new Mover(
        name,
        seenMicros,
        0.0,
        new double[] {norths[0]},
        new double[] {easts[0]},
        newNorthMps,
        newEastMps,
        radiusM,
        sigmaM,
        sigmaMps,
        new Heights(new double[] {heights.downs[0]}, 0.0, heights.halfM));
  }

  /** Age of the data [s] at a time. */
  public double ageS(long micros) {
    return (micros - seenMicros) * MICROS;
  }

  /** North coordinate of its centre at a time after the observation [m]. */
  public double northAfterM(double seconds) {
    return after(norths, northMps, seconds);
  }

  /** East coordinate of its centre at a time after the observation [m]. */
  public double eastAfterM(double seconds) {
    return after(easts, eastMps, seconds);
  }

  /** Down coordinate of its centre at a time after the observation [m]. */
  public double downAfterM(double seconds) {
    return after(heights.downs, heights.downMps, seconds);
  }

  private double after(double[] points, double velocity, double seconds) {
    int last = stepS > 0.0 ? points.length - 1 : 0; // without a step, the other points have no time
    if (last == 0 || seconds >= last * stepS) {
      return points[last] + velocity * (seconds - last * stepS);
    }
    int at = (int) Math.max(0.0, seconds / stepS);
    double share = seconds / stepS - at;
    return points[at] + share * (points[at + 1] - points[at]);
  }
}
