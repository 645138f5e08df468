package org.u2sa.core.planning;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.HandOver;

/** What a planner does while it has no goal to pursue: hold at a place, or nothing. */
final class EndOfMission {
  private final Supplier<PlanningSettings> settings;
  private final Supplier<LineSettings> lines;
  private final WaypointGuidance guidance;
  private Optional<LoiterCircle> circle = Optional.empty();

  /**
   * @param settings whether to hold, and on what circle
   * @param lines how far ahead on the circle to go
   * @param guidance for the form of the point handed to control
   */
  EndOfMission(
      Supplier<PlanningSettings> settings,
      Supplier<LineSettings> lines,
      WaypointGuidance guidance) {
    this.settings = settings;
    this.lines = lines;
    this.guidance = guidance;
  }

  /** Writes down where it holds, for a planner that takes over. */
  void handOver(HandOver state) {
    circle.ifPresent(held -> held.handOver(state));
  }

  /** Holds where the planner before held. */
  void takeOver(HandOver state) {
    circle = LoiterCircle.takenOver(state);
  }

  /** Forgets where it held: a goal is pursued again. */
  void leave() {
    circle = Optional.empty();
  }

  /**
   * The next step of holding.
   *
   * @param place where to hold; if empty or without coordinates, where the vehicle was when holding
   *     began; at the altitude that it had then if the place has none
   */
  List<NavigationPoint> plan(Vehicle vehicle, Optional<Place> place) {
    return settings.get().holdsAtEnd() ? hold(vehicle, place) : List.of();
  }

  /**
   * The next step of holding because a failsafe says so, whatever AT END says: what cannot stand
   * circles. A vehicle that is to stop at the end and has no circle stops here too.
   *
   * @param place as {@link #plan} says
   */
  List<NavigationPoint> planFailsafe(Vehicle vehicle, Optional<Place> place) {
    PlanningSettings now = settings.get();
    return now.holdsAtEnd() || now.loiterRadius() > 0.0 ? hold(vehicle, place) : List.of();
  }

  private List<NavigationPoint> hold(Vehicle vehicle, Optional<Place> place) {
    PlanningSettings now = settings.get();
    if (circle.isEmpty()) {
      Place centre =
          place
              .filter(Place::isHorizontal)
              .map(known -> known.orAltitudeOf(vehicle.place()))
              .orElse(vehicle.place());
      circle = Optional.of(new LoiterCircle(centre, now.loiterRadius(), vehicle));
    }
    Point ahead = circle.get().ahead(vehicle, lines.get().lookAheadM(vehicle.speedMps()));
    return List.of(NavigationPoint.at(guidance.bodyPoint(vehicle, ahead)));
  }
}
