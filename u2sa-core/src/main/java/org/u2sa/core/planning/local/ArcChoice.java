package org.u2sa.core.planning.local;

/**
 * Where the vehicle is to go next.
 *
 * @param northM on the planning plane [m]
 * @param eastM on the planning plane [m]
 * @param speedMps at which [m/s]
 * @param backwards whether with the rear first
 * @param kind what that is
 */
public record ArcChoice(
    double northM, double eastM, double speedMps, boolean backwards, Kind kind) {
  /** What a choice is for. */
  public enum Kind {
    /** Along the route. */
    FOLLOW,
    /** Off the route, past something. */
    EVADE,
    /** Out of a corner that is too narrow to turn in; it goes on until it is not. */
    MAKE_ROOM,
    /** It stands until traffic has passed, or until there is a way. */
    WAIT,
    /** No motion avoids a collision: it brakes, or turns to where it comes latest. */
    BRAKE
  }

  /** The same, for another reason. */
  ArcChoice as(Kind other) {
    return new ArcChoice(northM, eastM, speedMps, backwards, other);
  }
}
