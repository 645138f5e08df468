package org.u2sa.planning.avoidance;

import java.util.Optional;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;

/**
 * Ground that a multirotor has below it whatever a map says: the place of its landing, or where it
 * last stood. Immutable.
 *
 * @param place place on the ground; empty if unknown
 * @param lands whether it is the place to land on
 * @param touchesDown whether the vehicle is touching down there, or has
 */
public record KnownGround(Optional<Place> place, boolean lands, boolean touchesDown) {
  /** Radius around the place in which the ground counts as level [m]. */
  public static final double REACH_M = 10.0;

  private static final double LOW_M = 1.0; // height of a touch-down

  /** Place to land on; empty if the vehicle does not land. */
  Optional<Place> landing() {
    return lands ? place : Optional.empty();
  }

  /**
   * The place on the plane: north, east, down [m]; empty if the vehicle is not above it or
   * altitudes are unknown.
   *
   * @param at vehicle on the plane [m]
   */
  Optional<Point> spot(Vehicle vehicle, Point at) {
    Place here = vehicle.place();
    return place
        .filter(known -> known.onEarth() == here.onEarth())
        .filter(known -> known.upM().isPresent() && here.upM().isPresent())
        .map(vehicle::nedOf)
        .filter(way -> Math.hypot(way.x(), way.y()) < REACH_M)
        .map(way -> Point.of(at.x() + way.x(), at.y() + way.y(), at.z() + way.z()));
  }

  /** Whether a vehicle is so low above the spot that it must not evade upwards. */
  static boolean isLow(Point spot, Point at) {
    return spot.z() - at.z() < LOW_M;
  }
}
