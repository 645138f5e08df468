package org.u2sa.planning;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import org.u2sa.interfaces.time.Clock;
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
  private static final double AT_REST_MPS = 0.1;
  private static final double BRAKE_AHEAD_S = 0.3; // longer than a control's delay
  private static final long LONGEST_BRAKING_MICROS = 10 * Clock.MICROS_PER_SECOND;

  private final Supplier<PlanningVariables> settings;
  private final Supplier<LineSettings> lines;
  private final WaypointGuidance guidance;
  private final UnaryOperator<Place> raised;
  private Optional<LoiterCircle> circle = Optional.empty();
  private OptionalLong brakesMicros = OptionalLong.empty(); // since when

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
    brakesMicros = OptionalLong.empty();
  }

  /**
   * Plans the next step of holding: vehicles that cannot stop circle, even with AT END = STOP;
   * others stop with it.
   *
   * @param place position to hold; if empty or without coordinates, the vehicle's position when
   *     holding began, or with HOLD AT REST when it has stopped; without altitude, its altitude at
   *     that time
   */
  List<NavigationPoint> plan(Vehicle vehicle, Optional<Place> place) {
    PlanningVariables now = settings.get();
    return now.holdsAtEnd() || now.loiterRadius() > 0.0 ? hold(vehicle, place) : List.of();
  }

  private List<NavigationPoint> hold(Vehicle vehicle, Optional<Place> place) {
    PlanningVariables now = settings.get();
    boolean isPlaced = circle.isPresent() || place.filter(Place::isHorizontal).isPresent();
    if (!isPlaced && now.holdAtRest() && now.loiterRadius() == 0.0 && isMoving(vehicle)) {
      return List.of(braking(vehicle));
    }
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

  /** Whether it still brakes; a vehicle that does not stop counts as standing after a while. */
  private boolean isMoving(Vehicle vehicle) {
    long now = vehicle.timestampMicros();
    if (brakesMicros.isEmpty()) {
      brakesMicros = OptionalLong.of(now);
    }
    return vehicle.speedMps() > AT_REST_MPS
        && now - brakesMicros.getAsLong() < LONGEST_BRAKING_MICROS;
  }

  /**
   * Point at a speed of 0 that a moving vehicle has not yet passed when its control receives it, so
   * that it brakes without turning.
   */
  private static NavigationPoint braking(Vehicle vehicle) {
    double north = vehicle.northMps() * BRAKE_AHEAD_S;
    double east = vehicle.eastMps() * BRAKE_AHEAD_S;
    Point ahead = vehicle.body(Point.of(north, east, 0.0));
    return NavigationPoint.at(ahead).speed(0.0).backwards(ahead.x() < 0.0);
  }
}
