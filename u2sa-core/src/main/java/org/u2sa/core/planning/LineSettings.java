package org.u2sa.core.planning;

/**
 * How lines are followed.
 *
 * @param leastLookAheadM look-ahead of a slow vehicle [m]
 * @param lookAheadS look-ahead of a fast vehicle, in time of its way over ground [s]
 * @param turns how the vehicle turns
 * @param altitudes how altitude changes along a leg
 */
record LineSettings(
    double leastLookAheadM, double lookAheadS, TurnAnticipation turns, AltitudeProfile altitudes) {
  /** How far ahead of the vehicle's foot on its leg the point to go to lies [m]. */
  double lookAheadM(double speedMps) {
    return Math.max(leastLookAheadM, lookAheadS * speedMps);
  }
}
