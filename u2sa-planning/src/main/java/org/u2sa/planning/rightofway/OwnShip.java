package org.u2sa.planning.rightofway;

/**
 * The vehicle at the time of a decision. Immutable.
 *
 * @param northM north coordinate [m]
 * @param eastM east coordinate [m]
 * @param northMps northward velocity over ground [m/s]
 * @param eastMps eastward velocity over ground [m/s]
 * @param courseRad course to its goal or along its route, clockwise from north [rad]
 * @param speedMps desired speed over ground [m/s]
 * @param limits limits of its motion
 */
public record OwnShip(
    double northM,
    double eastM,
    double northMps,
    double eastMps,
    double courseRad,
    double speedMps,
    Limits limits) {

  /**
   * Limits of the vehicle's motion. Immutable.
   *
   * @param radiusM radius around its reference point [m]
   * @param turnRadPerS turn rate at its speed [rad/s]
   * @param brakingMps2 deceleration [m/s²]
   * @param reactionS delay until it responds [s]
   * @param slowestMps minimum speed [m/s]; 0 if it can stop
   */
  public record Limits(
      double radiusM,
      double turnRadPerS,
      double brakingMps2,
      double reactionS,
      double slowestMps) {}

  /** Course over ground, or the desired one if the vehicle hardly moves [rad]. */
  double presentCourseRad() {
    return Math.hypot(northMps, eastMps) > 0.3 * speedMps
        ? Math.atan2(eastMps, northMps)
        : courseRad;
  }

  /**
   * A target's motion relative to the vehicle after it has changed to a course and speed. During
   * the change, the vehicle on average moves at the mean of both velocities.
   */
  Approach approach(Target target, double newCourseRad, double newMps) {
    double north = newMps * Math.cos(newCourseRad);
    double east = newMps * Math.sin(newCourseRad);
    double turn = Math.abs(Angles.wrapped(newCourseRad - presentCourseRad()));
    double slower = Math.max(0.0, Math.hypot(northMps, eastMps) - newMps);
    double changeS =
        limits.reactionS + Math.max(turn / limits.turnRadPerS, slower / limits.brakingMps2);
    double laggedNorth = 0.5 * changeS * (northMps - north);
    double laggedEast = 0.5 * changeS * (eastMps - east);
    return new Approach(
        target.northM() - northM - laggedNorth,
        target.eastM() - eastM - laggedEast,
        target.northMps() - north,
        target.eastMps() - east);
  }

  /** A target's motion relative to the vehicle on its present course at its present speed. */
  Approach presentApproach(Target target) {
    return new Approach(
        target.northM() - northM,
        target.eastM() - eastM,
        target.northMps() - northMps,
        target.eastMps() - eastMps);
  }
}
