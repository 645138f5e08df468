package org.u2sa.planning;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.Landing;
import org.u2sa.planning.avoidance.Avoidance;
import org.u2sa.planning.flight.FlightVariables;
import org.u2sa.planning.guidance.Leg;
import org.u2sa.planning.guidance.LineGuidance;
import org.u2sa.planning.guidance.LineSettings;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.service.handover.HandOver;

/**
 * Landing of a multirotor: level flight to above the position, then descent. It rises straight up
 * first if it is low, also when the position moves away below it.
 */
final class VerticalDescent implements LandingState.Descent {
  private static final double ASIDE_M = 8.0; // beyond the threshold, from where it comes back level
  private static final double SIGMAS = 2.0; // of the altitude, by which the ground may come sooner
  private static final double SLOW_BELOW_M = 4.0; // height above the ground given by the goal
  private static final double FAR_M = 10.0; // from the position
  private static final double LOW_M = 3.0; // height up to which it must not lean
  private static final String DOWN = "DOWN";

  private final Detour detour;
  private final Supplier<FlightVariables> settings;
  private final LineGuidance guidance;
  private boolean above;
  private boolean rises; // straight up, before it may lean
  private double altitudeM; // altitude on the way there
  private Optional<Place> aimedAt = Optional.empty(); // position at the last state

  VerticalDescent(Detour detour, Supplier<LineSettings> lines, Supplier<FlightVariables> settings) {
    this.detour = detour;
    this.settings = settings;
    guidance = new LineGuidance(lines);
  }

  @Override
  public void begin(Landing goal, StateInformation state, Vehicle vehicle) {
    guidance.begin(Optional.empty());
    detour.begin();
    above = false;
    rises = false;
    altitudeM = vehicle.place().upM().orElse(0.0);
  }

  @Override
  public Plan plan(Landing goal, StateInformation state, Vehicle vehicle) {
    Place place = Place.of(goal);
    Point to = vehicle.nedOf(place);
    boolean isHighEnough = to.z() > -SLOW_BELOW_M;
    boolean isOver = isHighEnough && Math.hypot(to.x(), to.y()) <= goal.horizontalThreshold();
    if (above && !isOver && !aimedAt.equals(Optional.of(place))) {
      begin(goal, state, vehicle);
    }
    boolean isHigh = to.z() > LOW_M + SIGMAS * state.zSigma().orElse(0.0);
    if (above && isHigh && Math.hypot(to.x(), to.y()) > goal.horizontalThreshold() + ASIDE_M) {
      begin(goal, state, vehicle); // it has evaded traffic
    }
    aimedAt = Optional.of(place);
    above |= isOver && !rises;
    if (!above) {
      rises = to.z() < LOW_M;
      if (rises) {
        Point up = Point.of(0.0, 0.0, to.z() - SLOW_BELOW_M);
        return Plan.underWay(List.of(NavigationPoint.at(vehicle.body(up))));
      }
      double leastM = place.upM().orElse(altitudeM) + SLOW_BELOW_M; // as onto a roof
      altitudeM = Math.max(altitudeM, leastM);
      Place over = place.at(altitudeM);
      Optional<Plan> around =
          detour.ifHindered(
              vehicle,
              state,
              new Avoidance.Wanted(
                  goal.uid(),
                  over,
                  goal.horizontalThreshold(),
                  OptionalDouble.empty(),
                  goal.speed()),
              guidance.isApproaching());
      if (around.isPresent()) {
        guidance.begin(Optional.empty()); // the line that it has left may be obstructed
        return around.get();
      }
      Point body = guidance.towards(vehicle, over, goal.horizontalThreshold(), Optional.empty());
      NavigationPoint point = NavigationPoint.at(body);
      goal.speed().ifPresent(point::speed);
      return Plan.underWay(List.of(point));
    }
    // Near the ground, the target moves along, because control sinks in proportion to its distance.
    double slowM = SLOW_BELOW_M + SIGMAS * state.zSigma().orElse(0.0);
    double downM = Math.max(to.z() - slowM, settings.get().touchDownSink());
    NavigationPoint down = NavigationPoint.at(vehicle.body(Point.of(to.x(), to.y(), downM)));
    goal.psi().ifPresent(psi -> down.turn(Leg.wrapped(psi - vehicle.headingRad())));
    return Plan.underWay(List.of(down));
  }

  @Override
  public boolean isFinal() {
    return above;
  }

  @Override
  public double farM(Landing goal) {
    return Math.max(FAR_M, goal.horizontalThreshold());
  }

  @Override
  public String manoeuvre() {
    return above ? DOWN : "";
  }

  @Override
  public void handOver(HandOver state) {
    state.flag("ABOVE", above).flag("RISES", rises).number("LANDING FROM", altitudeM);
    aimedAt.ifPresent(place -> place.handOver(state, "LANDING AT"));
    guidance.handOver(state);
  }

  @Override
  public boolean takeOver(HandOver state) {
    if (state.number("LANDING FROM").isEmpty()) {
      return false;
    }
    guidance.begin(Optional.empty());
    guidance.takeOver(state);
    detour.begin();
    above = state.flag("ABOVE");
    rises = state.flag("RISES");
    altitudeM = state.number("LANDING FROM").getAsDouble();
    aimedAt = Place.takenOver(state, "LANDING AT");
    return true;
  }

  /** {@inheritDoc} Otherwise it might lift off again, being a little aside. */
  @Override
  public boolean isStillIn(String manoeuvre, Landing goal, Vehicle vehicle) {
    Point to = vehicle.nedOf(Place.of(goal));
    return manoeuvre.equals(DOWN)
        && Math.hypot(to.x(), to.y()) <= goal.horizontalThreshold() + ASIDE_M;
  }
}
