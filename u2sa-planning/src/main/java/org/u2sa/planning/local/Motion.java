package org.u2sa.planning.local;

/**
 * Candidate motion of a vehicle: an optional turn in place, then an arc, then along its route or
 * straight on.
 *
 * @param turnRad initial turn in place, right positive [rad]; 0 for none
 * @param curvature curvature of the arc [1/m], right positive
 * @param backwards whether in reverse
 * @param speedMps wanted speed [m/s]
 * @param arcM length of the arc [m]
 * @param endM distance at which it stops [m]; infinite if it does not stop
 * @param track route followed after the arc; null for straight on
 * @param toDownM altitude of an evasion, down coordinate [m]; NaN: that of the goal
 */
record Motion(
    double turnRad,
    double curvature,
    boolean backwards,
    double speedMps,
    double arcM,
    double endM,
    RouteTrack track,
    double toDownM) {
  private static final double NEVER = Double.POSITIVE_INFINITY;
  private static final double TO_GOAL = Double.NaN;

  /** Creates an arc followed by a straight line. */
  static Motion arc(double curvature, boolean backwards, double speedMps, double arcM) {
    return new Motion(0.0, curvature, backwards, speedMps, arcM, NEVER, null, TO_GOAL);
  }

  /** Creates a turn in place followed by a straight line. */
  static Motion turn(double turnRad, double speedMps, double wayM) {
    return turn(turnRad, speedMps, wayM, null);
  }

  /** Creates a turn in place followed by a straight line to a route, and by the route. */
  static Motion turn(double turnRad, double speedMps, double wayM, RouteTrack track) {
    return new Motion(turnRad, 0.0, false, speedMps, wayM, NEVER, track, TO_GOAL);
  }

  /** Creates a forward arc followed by a route. */
  static Motion along(
      RouteTrack track, double curvature, boolean backwards, double speedMps, double arcM) {
    return new Motion(0.0, curvature, backwards, speedMps, arcM, NEVER, track, TO_GOAL);
  }

  Motion endingAt(double metres) {
    return new Motion(turnRad, curvature, backwards, speedMps, arcM, metres, track, toDownM);
  }

  /** Copy at a different altitude; NaN: the goal's. */
  Motion at(double downM) {
    return new Motion(turnRad, curvature, backwards, speedMps, arcM, endM, track, downM);
  }

  /** 1 forward, −1 in reverse. */
  double sign() {
    return backwards ? -1.0 : 1.0;
  }
}
