package org.u2sa.core.planning;

import org.u2sa.messages.frame.Point;

/**
 * A circle to stay on around a place. Radius 0 holds the place itself.
 *
 * <p>It is flown in the sense in which the vehicle comes: clockwise if the centre is on its right.
 */
final class LoiterCircle {
  private static final double FARTHEST_AHEAD_RAD = 1.0;

  private final Place centre;
  private final double radiusM;
  private final double sense; // 1 clockwise, -1 counter-clockwise

  /**
   * @param vehicle as it is when the loiter begins
   */
  LoiterCircle(Place centre, double radiusM, Vehicle vehicle) {
    this.centre = centre;
    this.radiusM = radiusM;
    Point to = vehicle.nedOf(centre);
    double course = vehicle.courseRad();
    sense = to.y() * Math.cos(course) - to.x() * Math.sin(course) >= 0.0 ? 1.0 : -1.0;
  }

  /**
   * The point of the circle so far ahead of the vehicle's foot on it: north, east, down [m] from
   * the vehicle.
   */
  Point ahead(Vehicle vehicle, double lookAheadM) {
    Point to = vehicle.nedOf(centre);
    if (radiusM == 0.0) {
      return to;
    }
    boolean atCentre = Math.hypot(to.x(), to.y()) < Leg.SHORTEST_M;
    double angle = atCentre ? vehicle.courseRad() : Math.atan2(-to.y(), -to.x());
    angle += sense * Math.min(lookAheadM / radiusM, FARTHEST_AHEAD_RAD);
    return Point.of(to.x() + radiusM * Math.cos(angle), to.y() + radiusM * Math.sin(angle), to.z());
  }
}
