package org.u2sa.planning.guidance;

/**
 * Settings of line following.
 *
 * @param leastLookAheadM minimum look-ahead [m]
 * @param lookAheadS look-ahead time of a fast vehicle, multiplied by its ground speed [s]
 * @param turns how the vehicle turns
 * @param altitudes how altitude changes along a leg
 */
public record LineSettings(
    double leastLookAheadM, double lookAheadS, TurnAnticipation turns, AltitudeProfile altitudes) {
  /** Look-ahead from the vehicle's projection on its leg to the target point [m]. */
  public double lookAheadM(double speedMps) {
    return Math.max(leastLookAheadM, lookAheadS * speedMps);
  }
}
