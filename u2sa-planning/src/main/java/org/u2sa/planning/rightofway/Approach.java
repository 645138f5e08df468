package org.u2sa.planning.rightofway;

/**
 * Straight motion of a target relative to the vehicle. Immutable.
 *
 * @param northM target's position relative to the vehicle now, north [m]
 * @param eastM the same, east [m]
 * @param northMps target's velocity relative to the vehicle, north [m/s]
 * @param eastMps the same, east [m/s]
 */
record Approach(double northM, double eastM, double northMps, double eastMps) {
  private static final double NO_MOTION = 1.0e-9; // [m²/s²]

  /** Time of the closest point of approach [s]: negative if past, 0 without relative motion. */
  double closestS() {
    double square = northMps * northMps + eastMps * eastMps;
    return square < NO_MOTION ? 0.0 : -(northM * northMps + eastM * eastMps) / square;
  }

  double rangeM() {
    return Math.hypot(northM, eastM);
  }

  double distanceM(double seconds) {
    return Math.hypot(northM + northMps * seconds, eastM + eastMps * seconds);
  }

  /** Bearing of the target, clockwise from north [rad]. */
  double bearingRad() {
    return Math.atan2(eastM, northM);
  }

  /**
   * Whether the target is to starboard of the vehicle when it is closest.
   *
   * @param courseRad course of the vehicle
   */
  boolean passesToStarboard(double courseRad) {
    double time = Math.max(0.0, closestS());
    double north = northM + northMps * time;
    double east = eastM + eastMps * time;
    return Math.cos(courseRad) * east - Math.sin(courseRad) * north > 0.0;
  }

  /**
   * Distance ahead of a target at which the vehicle crosses its course line within a time [m];
   * infinite if it does not, or astern.
   */
  double crossesAheadM(Target target, double withinS) {
    double north = Math.cos(target.courseRad());
    double east = Math.sin(target.courseRad());
    double across = -(north * eastM - east * northM); // speed to the target's starboard
    double acrossMps = -(north * eastMps - east * northMps);
    double time = -across / acrossMps;
    if (!(time > 0.0 && time < withinS)) {
      return Double.POSITIVE_INFINITY;
    }
    double ahead = -(north * (northM + northMps * time) + east * (eastM + eastMps * time));
    return ahead > 0.0 ? ahead : Double.POSITIVE_INFINITY;
  }
}
