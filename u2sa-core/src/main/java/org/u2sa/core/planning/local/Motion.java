package org.u2sa.core.planning.local;

/**
 * What a vehicle might do next: perhaps turn on the spot, then drive an arc, then follow its route
 * or go straight on.
 *
 * @param turnRad to be turned on the spot first, to the right positive [rad]; 0: not at all
 * @param curvature of the arc [1/m], to the right positive
 * @param backwards whether with the rear first
 * @param speedMps wanted [m/s]
 * @param arcM length of the arc [m]
 * @param endM where it stops of itself [m]; infinite: nowhere
 * @param track followed after the arc; null: straight on
 */
record Motion(
    double turnRad,
    double curvature,
    boolean backwards,
    double speedMps,
    double arcM,
    double endM,
    RouteTrack track) {
  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** An arc, and straight on. */
  static Motion arc(double curvature, boolean backwards, double speedMps, double arcM) {
    return new Motion(0.0, curvature, backwards, speedMps, arcM, NEVER, null);
  }

  /** A turn on the spot, and straight ahead. */
  static Motion turn(double turnRad, double speedMps, double wayM) {
    return new Motion(turnRad, 0.0, false, speedMps, wayM, NEVER, null);
  }

  /** An arc forward, and on along a route. */
  static Motion along(
      RouteTrack track, double curvature, boolean backwards, double speedMps, double arcM) {
    return new Motion(0.0, curvature, backwards, speedMps, arcM, NEVER, track);
  }

  /** The same, to a stop. */
  Motion endingAt(double metres) {
    return new Motion(turnRad, curvature, backwards, speedMps, arcM, metres, track);
  }

  /** 1 forwards, −1 backwards. */
  double sign() {
    return backwards ? -1.0 : 1.0;
  }
}
