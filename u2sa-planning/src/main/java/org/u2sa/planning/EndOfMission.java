package org.u2sa.planning;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.guidance.WaypointGuidance;
import org.u2sa.planning.station.HoldingPlace;
import org.u2sa.service.handover.HandOver;

/** Behaviour of a planner without a goal: hold a position, or do nothing. */
final class EndOfMission {
  private static final double AT_REST_MPS = 0.1;
  private static final long LONGEST_BRAKING_MICROS = 10 * Clock.MICROS_PER_SECOND;

  private final Supplier<PlanningVariables> settings;
  private final BooleanSupplier drifts;
  private final WaypointGuidance guidance;
  private final UnaryOperator<Place> raised;
  private final StationCircle circle;
  private final Detour detour;
  private final SurfaceHold surface;
  private Optional<Place> held = Optional.empty(); // position, or centre of the circle
  private OptionalLong brakesMicros = OptionalLong.empty(); // since when

  /**
   * @param drifts whether the vehicle drifts, so that it never comes to rest
   * @param raised changes the altitude of a place that is too low
   * @param circle of a vehicle that cannot stop
   * @param detour looks whether places, and the way back to a held position, are free
   */
  EndOfMission(
      Supplier<PlanningVariables> settings,
      BooleanSupplier drifts,
      WaypointGuidance guidance,
      UnaryOperator<Place> raised,
      StationCircle circle,
      Detour detour) {
    this.detour = detour;
    surface = new SurfaceHold(detour);
    this.raised = raised;
    this.circle = circle;
    this.settings = settings;
    this.drifts = drifts;
    this.guidance = guidance;
  }

  /** Saves the holding position for the planner that takes over. */
  void handOver(HandOver state) {
    held.ifPresent(place -> place.handOver(state, "HELD"));
    if (held.isPresent()) {
      circle.handOver(state, "HELD CIRCLE");
    }
  }

  /** Resumes holding where the previous planner held. */
  void takeOver(HandOver state) {
    held = Place.takenOver(state, "HELD");
    circle.takeOver(state, "HELD CIRCLE");
  }

  /** Discards the holding position because a goal is pursued again. */
  void leave() {
    held = Optional.empty();
    circle.leave();
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
    if (now.loiterRadius() > 0.0) {
      return circle(vehicle, state, place);
    }
    return now.holdsAtEnd() ? List.of(hold(vehicle, state, place)) : List.of();
  }

  private List<NavigationPoint> circle(
      Vehicle vehicle, StateInformation state, Optional<Place> place) {
    if (held.isEmpty()) {
      Optional<Place> given = place.filter(Place::isHorizontal);
      Place about = raised.apply(given.orElse(vehicle.place()).orAltitudeOf(vehicle.place()));
      HoldingPlace places =
          new HoldingPlace(
              settings.get().loiterRadius(),
              each -> detour.isClosedAt(vehicle, state, each),
              each -> detour.isInsideFence(vehicle, state, each));
      held = Optional.of(places.near(about, given.isEmpty(), vehicle));
    }
    return circle.hold(held.get(), state, vehicle);
  }

  private NavigationPoint hold(Vehicle vehicle, StateInformation state, Optional<Place> place) {
    boolean isTaken =
        place.isEmpty() && held.filter(at -> surface.isTaken(vehicle, state, at)).isPresent();
    if (isTaken) {
      leave(); // it holds here
    }
    boolean isPlaced = held.isPresent() || place.filter(Place::isHorizontal).isPresent();
    boolean rests = settings.get().holdAtRest() && !drifts.getAsBoolean();
    if (!isPlaced && rests && isMoving(vehicle)) {
      return SurfaceHold.braking(vehicle);
    }
    if (held.isEmpty()) {
      Place at =
          place
              .filter(Place::isHorizontal)
              .map(known -> known.orAltitudeOf(vehicle.place()))
              .orElseGet(() -> isTaken ? SurfaceHold.ahead(vehicle) : vehicle.place());
      held = Optional.of(raised.apply(at));
    }
    Place at = held.get();
    NavigationPoint point = NavigationPoint.at(guidance.bodyPoint(vehicle, vehicle.nedOf(at)));
    surface.lead(point, vehicle, state, at);
    return surface.stop(vehicle, at).orElse(point);
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
