package org.u2sa.planning.flight;

import java.util.List;
import java.util.Optional;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.avoidance.Avoidance;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;

/**
 * Place of an aircraft that hovers without navigation points: it gets some only to evade traffic,
 * and back to where it was.
 */
final class HoverPlace {
  private static final double BACK_M = 1.0; // from the place
  private static final double STILL_MPS = 0.3; // then it stays where it is

  private final Avoidance avoidance;
  private Optional<Place> place = Optional.empty(); // while it evades and returns

  HoverPlace(Avoidance avoidance) {
    this.avoidance = avoidance;
  }

  /** Forgets the place. */
  void leave() {
    place = Optional.empty();
  }

  /** Points to evade traffic or to return; empty if it stays. */
  List<NavigationPoint> points(StateInformation state) {
    Vehicle vehicle = Vehicle.of(state).orElseThrow();
    Place here = place.orElse(vehicle.place());
    Point way = vehicle.nedOf(here);
    NavigationPoint point = NavigationPoint.at(vehicle.body(way));
    boolean evades = avoidance.hover(vehicle, state, point);
    boolean isBack = way.distance() <= BACK_M && vehicle.speedMps() <= STILL_MPS;
    boolean returns = place.isPresent() && !isBack;
    place = evades || returns ? Optional.of(here) : Optional.empty();
    return place.isPresent() ? List.of(point) : List.of();
  }
}
