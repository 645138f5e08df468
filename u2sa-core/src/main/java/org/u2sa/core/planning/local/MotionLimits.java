package org.u2sa.core.planning.local;

/**
 * How a vehicle may move along its route. Immutable.
 *
 * @param speedMps wanted [m/s]
 * @param accelerationMps2 [m/s²]
 * @param brakingMps2 [m/s²]
 * @param turnRadiusM of its tightest turn at that speed [m]; 0 if it turns on the spot
 * @param stops whether it can stand: an aeroplane cannot
 * @param reverses whether it can go backwards
 * @param lookAheadM how far ahead on the route it is led [m]
 * @param touchM nearer to an obstacle than this counts as a collision [m]
 * @param trafficM to be kept from traffic beyond both radii [m]
 * @param horizonS how far ahead in time traffic is looked at [s]
 * @param reactionS time until an order takes effect [s]
 */
public record MotionLimits(
    double speedMps,
    double accelerationMps2,
    double brakingMps2,
    double turnRadiusM,
    boolean stops,
    boolean reverses,
    double lookAheadM,
    double touchM,
    double trafficM,
    double horizonS,
    double reactionS) {
  /** Whether it turns on the spot. */
  boolean turnsOnTheSpot() {
    return turnRadiusM == 0.0;
  }

  /** Way to stop from a speed, reaction included [m]. */
  double stoppingM(double fromMps) {
    return fromMps * fromMps / (2.0 * brakingMps2) + fromMps * reactionS;
  }
}
