package org.u2sa.planning.seen;

/**
 * Altitudes that an aircraft will fly on its way to a goal: it climbs or descends at once, then
 * flies level. They determine which ground is too high for its route. Immutable.
 *
 * @param northM where it begins, on the planning plane [m]
 * @param eastM where it begins, on the planning plane [m]
 * @param downM down coordinate there [m]
 * @param goalDownM down coordinate of the goal [m]
 * @param slope of the climb or descent: metres per metre, at least 0
 * @param keptM distance to keep above ground [m]
 */
public record FlightProfile(
    double northM, double eastM, double downM, double goalDownM, double slope, double keptM) {

  /** Down coordinate of the aircraft if it flies straight to a position [m]. */
  public double downM(double north, double east) {
    double change =
        slope * Math.sqrt((north - northM) * (north - northM) + (east - eastM) * (east - eastM));
    return downM + Math.max(-change, Math.min(change, goalDownM - downM));
  }

  /** Whether ground is too high to fly over; false where it is unknown (NaN). */
  public boolean isTooHigh(double north, double east, double groundDownM) {
    return downM(north, east) + keptM > groundDownM;
  }
}
