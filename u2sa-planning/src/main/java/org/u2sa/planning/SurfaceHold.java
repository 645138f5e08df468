package org.u2sa.planning;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.avoidance.Avoidance;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;

/**
 * Decides how a vehicle that can stop gets back to the position that it holds. On a surface it goes
 * back only where nothing is in the way, and no faster than it can stop there. One that cannot turn
 * in place stays stopped, instead of circling, until it has drifted farther than the diameter of
 * its turning circle.
 */
final class SurfaceHold {
  private static final double NEAR_M = 0.1; // of the position, where it need not look
  private static final double BRAKE_AHEAD_S = 0.3; // longer than a control's delay

  private final Detour detour;
  private boolean stands; // cannot turn in place, and does not go back for now

  SurfaceHold(Detour detour) {
    this.detour = detour;
  }

  /** Begins to hold another position, or none. */
  void begin() {
    stands = false;
  }

  /** Whether the way back to a position is not known to be free. */
  boolean isTaken(Vehicle vehicle, StateInformation state, Place place) {
    Point way = vehicle.nedOf(place);
    return Math.hypot(way.x(), way.y()) > NEAR_M && detour.isReturnBlocked(vehicle, state, place);
  }

  /** Goes back to the position. */
  void lead(NavigationPoint point, Vehicle vehicle, StateInformation state, Place place) {
    Avoidance.Wanted wanted =
        new Avoidance.Wanted("", place, 0.0, OptionalDouble.empty(), OptionalDouble.empty());
    detour.straightMps(vehicle, state, wanted, false).ifPresent(point::speed);
    if (detour.goesAstern(vehicle, state, place)) {
      detour.leadAstern(point);
    }
  }

  /** A stop of a vehicle that cannot turn in place and would have to circle to the position. */
  Optional<NavigationPoint> stop(Vehicle vehicle, Place place) {
    double radiusM = detour.turnRadiusM(vehicle);
    if (radiusM == 0.0) {
      return Optional.empty();
    }
    Point way = vehicle.body(vehicle.nedOf(place));
    double toGoM = Math.hypot(way.x(), way.y());
    boolean isFar = toGoM > 2.0 * radiusM;
    boolean isOnAnArc = way.x() > 0.0 && toGoM * toGoM >= 2.0 * radiusM * Math.abs(way.y());
    stands = !isFar && (stands || !isOnAnArc);
    return stands ? Optional.of(braking(vehicle)) : Optional.empty();
  }

  /** Position that a moving vehicle has not yet passed when its control receives it. */
  static Place ahead(Vehicle vehicle) {
    Point soon = soon(vehicle);
    return vehicle.place().moved(soon.x(), soon.y());
  }

  /** Point at a speed of 0, so that it brakes without turning. */
  static NavigationPoint braking(Vehicle vehicle) {
    Point ahead = vehicle.body(soon(vehicle));
    return NavigationPoint.at(ahead).speed(0.0).backwards(ahead.x() < 0.0);
  }

  private static Point soon(Vehicle vehicle) {
    return Point.of(vehicle.northMps() * BRAKE_AHEAD_S, vehicle.eastMps() * BRAKE_AHEAD_S, 0.0);
  }
}
