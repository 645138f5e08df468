package org.u2sa.planning;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.guidance.LineSettings;
import org.u2sa.planning.guidance.LoiterCircle;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.guidance.WaypointGuidance;
import org.u2sa.service.handover.HandOver;

/** Behaviour of a planner without a goal: hold a position, or do nothing. */
final class EndOfMission {
  private final Supplier<PlanningVariables> settings;
  private final Supplier<LineSettings> lines;
  private final WaypointGuidance guidance;
  private final UnaryOperator<Place> raised;
  private Optional<LoiterCircle> circle = Optional.empty();

  /**
   * @param raised changes the altitude of a place that is too low
   */
  EndOfMission(
      Supplier<PlanningVariables> settings,
      Supplier<LineSettings> lines,
      WaypointGuidance guidance,
      UnaryOperator<Place> raised) {
    this.raised = raised;
    this.settings = settings;
    this.lines = lines;
    this.guidance = guidance;
  }

  /** Saves the holding position for the planner that takes over. */
  void handOver(HandOver state) {
    circle.ifPresent(held -> held.handOver(state));
  }

  /** Resumes holding where the previous planner held. */
  void takeOver(HandOver state) {
    circle = LoiterCircle.takenOver(state);
  }

  /** Discards the holding position because a goal is pursued again. */
  void leave() {
    circle = Optional.empty();
  }

  /**
   * Plans the next step of holding: vehicles that cannot stop circle, even with AT END = STOP;
   * others stop with it.
   *
   * @param place position to hold; if empty or without coordinates, the vehicle's position when
   *     holding began; without altitude, its altitude at that time
   */
  List<NavigationPoint> plan(Vehicle vehicle, Optional<Place> place) {
    PlanningVariables now = settings.get();
    return now.holdsAtEnd() || now.loiterRadius() > 0.0 ? hold(vehicle, place) : List.of();
  }

  private List<NavigationPoint> hold(Vehicle vehicle, Optional<Place> place) {
    PlanningVariables now = settings.get();
    if (circle.isEmpty()) {
      Place centre =
          place
              .filter(Place::isHorizontal)
              .map(known -> known.orAltitudeOf(vehicle.place()))
              .orElse(vehicle.place());
      circle = Optional.of(new LoiterCircle(raised.apply(centre), now.loiterRadius(), vehicle));
    }
    Point ahead = circle.get().ahead(vehicle, lines.get().lookAheadM(vehicle.speedMps()));
    return List.of(NavigationPoint.at(guidance.bodyPoint(vehicle, ahead)));
  }
}
