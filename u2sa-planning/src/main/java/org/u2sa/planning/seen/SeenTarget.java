package org.u2sa.planning.seen;

import org.u2sa.messages.frame.Point;

/**
 * Position of a goal object relative to the vehicle.
 *
 * @param ned vector to its centre: north, east, down [m]
 * @param topM down coordinate of its top [m]; that of its centre if its height is unknown
 * @param bottomM likewise of its bottom
 * @param distanceM horizontal distance to its surface [m]
 * @param radiusM distance from its centre to its surface, toward the vehicle [m]
 */
public record SeenTarget(Point ned, double topM, double bottomM, double distanceM, double radiusM) {

  /**
   * Where to go in order to come within a distance of it: up to half of the distance above or below
   * its centre, or else at the vehicle's own altitude, so that an aircraft does not dive at an
   * object on the ground.
   */
  public Point approach(double withinM) {
    double highest = topM - 0.5 * withinM;
    double lowest = bottomM + 0.5 * withinM;
    return Point.of(ned.x(), ned.y(), Math.max(highest, Math.min(lowest, 0.0)));
  }
}
