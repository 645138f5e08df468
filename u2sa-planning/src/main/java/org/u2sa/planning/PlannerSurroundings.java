package org.u2sa.planning;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.DoubleSupplier;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.planning.avoidance.Avoidance;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.seen.PlanarShape;
import org.u2sa.planning.seen.PlanningPlane;

/** {@link PlannerView} backed by the planner's own world and avoidance. */
final class PlannerSurroundings implements PlannerView {
  private final Avoidance avoidance;
  private final DoubleSupplier missionS;

  PlannerSurroundings(Avoidance avoidance, DoubleSupplier missionS) {
    this.avoidance = avoidance;
    this.missionS = missionS;
  }

  @Override
  public double missionS() {
    return missionS.getAsDouble();
  }

  @Override
  public List<ObjectDescription> objects() {
    return avoidance.world().objects();
  }

  @Override
  public Point centre(ObjectDescription object, StateInformation state) {
    return avoidance.world().centre(object, state);
  }

  @Override
  public List<PlanarShape> outlines(StateInformation state) {
    return avoidance.world().outlines(state);
  }

  @Override
  public double courseRad(StateInformation state) {
    return Vehicle.of(state).orElseThrow().courseRad();
  }

  @Override
  public Point onPlane(ReferenceFrame frame, Point point, StateInformation state) {
    return avoidance.world().plane(state).ned(frame, point);
  }

  @Override
  public NavigationPoint straight(StateInformation state, Point place) {
    Vehicle vehicle = Vehicle.of(state).orElseThrow();
    return NavigationPoint.at(vehicle.body(place.minus(here(state))));
  }

  @Override
  public Point here(StateInformation state) {
    return Vehicle.of(state).orElseThrow().on(avoidance.world().plane(state));
  }

  @Override
  public void begin() {
    avoidance.begin();
  }

  @Override
  public Step towards(Pursuit pursuit, Point to, double thresholdM, OptionalDouble speedMps) {
    Vehicle vehicle = Vehicle.of(pursuit.state()).orElseThrow();
    if (!avoidance.isOn()) {
      NavigationPoint point = straight(pursuit.state(), to);
      speedMps.ifPresent(point::speed);
      return new Step(point, Optional.empty());
    }
    PlanningPlane plane = avoidance.world().plane(pursuit.state());
    Place place = Place.of(plane.frame(), plane.point(to.x(), to.y(), to.z()));
    Avoidance.Step step =
        avoidance.step(
            vehicle,
            pursuit.state(),
            new Avoidance.Wanted(
                pursuit.goal().uid(), place, thresholdM, OptionalDouble.empty(), speedMps));
    return new Step(step.point(vehicle), step.givenUp());
  }
}
