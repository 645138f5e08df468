package org.u2sa.planning;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
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
  private static final long LONGEST_BRAKING_MICROS = 10 * Clock.MICROS_PER_SECOND;

  private final Supplier<PlanningVariables> settings;
  private final Supplier<LineSettings> lines;
  private final WaypointGuidance guidance;
  private final UnaryOperator<Place> raised;
  private final SurfaceHold surface;
  private Optional<LoiterCircle> circle = Optional.empty();
  private OptionalLong brakesMicros = OptionalLong.empty(); // since when

  /**
   * @param raised changes the altitude of a place that is too low
   * @param detour looks whether the way back to a held position is free
   */
  EndOfMission(
      Supplier<PlanningVariables> settings,
      Supplier<LineSettings> lines,
      WaypointGuidance guidance,
      UnaryOperator<Place> raised,
      Detour detour) {
    surface = new SurfaceHold(detour);
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
    surface.begin();
  }

  /**
   * Plans the next step of holding: vehicles that cannot stop circle, even with AT END = STOP;
   * others stop with it.
   *
   * @param place position to hold; if empty or without coordinates, the vehicle's position when
   *     holding began, or with HOLD AT REST when it has stopped; without altitude, its altitude at
   *     that time
   */
  List<NavigationPoint> plan(Vehicle vehicle, StateInformation state, Optional<Place> place) {
    PlanningVariables now = settings.get();
    return now.holdsAtEnd() || now.loiterRadius() > 0.0 ? hold(vehicle, state, place) : List.of();
  }

  private List<NavigationPoint> hold(
      Vehicle vehicle, StateInformation state, Optional<Place> place) {
    PlanningVariables now = settings.get();
    boolean isTaken =
        place.isEmpty()
            && now.loiterRadius() == 0.0
            && circle.filter(held -> surface.isTaken(vehicle, state, held.centre())).isPresent();
    if (isTaken) {
      leave(); // it holds here
    }
    boolean isPlaced = circle.isPresent() || place.filter(Place::isHorizontal).isPresent();
    if (!isPlaced && now.holdAtRest() && now.loiterRadius() == 0.0 && isMoving(vehicle)) {
      return List.of(SurfaceHold.braking(vehicle));
    }
    if (circle.isEmpty()) {
      Place centre =
          place
              .filter(Place::isHorizontal)
              .map(known -> known.orAltitudeOf(vehicle.place()))
              .orElseGet(() -> isTaken ? SurfaceHold.ahead(vehicle) : vehicle.place());
      circle = Optional.of(new LoiterCircle(raised.apply(centre), now.loiterRadius(), vehicle));
    }
    Point ahead = circle.get().ahead(vehicle, lines.get().lookAheadM(vehicle.speedMps()));
    NavigationPoint point = NavigationPoint.at(guidance.bodyPoint(vehicle, ahead));
    return List.of(now.loiterRadius() > 0.0 ? point : back(point, vehicle, state));
  }

  /** Goes back to the held position, or stops. */
  private NavigationPoint back(NavigationPoint point, Vehicle vehicle, StateInformation state) {
    Place held = circle.orElseThrow().centre();
    surface.lead(point, vehicle, state, held);
    return surface.stop(vehicle, held).orElse(point);
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
}
