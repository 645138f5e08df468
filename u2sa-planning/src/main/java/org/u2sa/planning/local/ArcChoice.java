package org.u2sa.planning.local;

/**
 * Next target of the vehicle.
 *
 * @param northM on the planning plane [m]
 * @param eastM on the planning plane [m]
 * @param speedMps speed [m/s]
 * @param backwards whether in reverse
 * @param kind purpose of the motion
 * @param toDownM altitude of an evasion, down coordinate [m]; NaN: that of the goal
 */
public record ArcChoice(
    double northM, double eastM, double speedMps, boolean backwards, Kind kind, double toDownM) {

  ArcChoice(double northM, double eastM, double speedMps, boolean backwards, Kind kind) {
    this(northM, eastM, speedMps, backwards, kind, Double.NaN);
  }

  /** Purpose of a choice. */
  public enum Kind {
    /** Follows the route. */
    FOLLOW,
    /** Leaves the route to go around something. */
    EVADE,
    /** Leaves a corner too narrow to turn in; continues until there is room. */
    MAKE_ROOM,
    /** Waits until traffic has passed or a route exists. */
    WAIT,
    /** No motion avoids a collision: brakes, or takes the motion with the latest collision. */
    BRAKE
  }

  ArcChoice as(Kind other) {
    return new ArcChoice(northM, eastM, speedMps, backwards, other, toDownM);
  }

  ArcChoice at(double downM) {
    return new ArcChoice(northM, eastM, speedMps, backwards, kind, downM);
  }
}
