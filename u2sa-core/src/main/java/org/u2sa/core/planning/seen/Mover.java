package org.u2sa.core.planning.seen;

/**
 * Traffic: a disc that moves on the planning plane, as far as known. Immutable.
 *
 * @param name UID of the object
 * @param seenMicros when it was where the first point says [µs]
 * @param stepS time from point to point [s]
 * @param norths where its centre is at each step [m], at least one
 * @param easts as many
 * @param northMps velocity after the last point [m/s]
 * @param eastMps the same, eastward
 * @param radiusM to be kept from its centre [m]
 */
public record Mover(
    String name,
    long seenMicros,
    double stepS,
    double[] norths,
    double[] easts,
    double northMps,
    double eastMps,
    double radiusM) {
  private static final double MICROS = 1.0e-6;

  /** Slower than this an object stands [m/s]. */
  private static final double STANDS_MPS = 0.05;

  /** Whether it stands now. */
  boolean stands() {
    return Math.hypot(northMps, eastMps) < STANDS_MPS;
  }

  /** The same with another velocity from where it is now. */
  Mover moving(double newNorthMps, double newEastMps) {
    return new Mover(
        name,
        seenMicros,
        0.0,
        new double[] {norths[0]},
        new double[] {easts[0]},
        newNorthMps,
        newEastMps,
        radiusM);
  }

  /** Age of what is known of it [s], at that time. */
  public double ageS(long micros) {
    return (micros - seenMicros) * MICROS;
  }

  /** North of its centre so long after it was seen [m]. */
  public double northAfterM(double seconds) {
    return after(norths, northMps, seconds);
  }

  /** East of its centre so long after it was seen [m]. */
  public double eastAfterM(double seconds) {
    return after(easts, eastMps, seconds);
  }

  private double after(double[] points, double velocity, double seconds) {
    int last = points.length - 1;
    if (stepS <= 0.0 || last == 0 || seconds >= last * stepS) {
      return points[last] + velocity * (seconds - (stepS > 0.0 ? last * stepS : 0.0));
    }
    int at = (int) Math.max(0.0, seconds / stepS);
    double share = seconds / stepS - at;
    return points[at] + share * (points[at + 1] - points[at]);
  }
}
