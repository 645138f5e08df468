package org.u2sa.planning.flight;

import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.DoubleSupplier;
import java.util.function.Supplier;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Landing;
import org.u2sa.messages.goal.TakeOff;
import org.u2sa.planning.avoidance.Avoidance;
import org.u2sa.planning.avoidance.KnownGround;
import org.u2sa.planning.guidance.HeadwayWatch;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;

/**
 * Last checks of each step of an aircraft: it evades traffic, does not climb or descend into what
 * is above or below, and gives up a goal towards which it makes no headway. They change the
 * vehicle's navigation point. Steps of other vehicles pass unchanged.
 */
public final class FlightChecks {
  private final Avoidance avoidance;
  private final HeadwayWatch headway;
  private final HoverPlace hover;
  private final Aircraft aircraft;

  /**
   * What the planner knows of its vehicle.
   *
   * @param flies whether it is in the air and not flown by hand
   * @param isAeroplane whether it can neither stop nor turn in place
   * @param stoodAt where it last stood on the ground; empty if unknown
   * @param headwayTimeS time without headway after which it gives a goal up [s]; 0: never
   */
  public record Aircraft(
      BooleanSupplier flies,
      BooleanSupplier isAeroplane,
      Supplier<Optional<Place>> stoodAt,
      DoubleSupplier headwayTimeS) {}

  public FlightChecks(Avoidance avoidance, HeadwayWatch headway, Aircraft aircraft) {
    this.avoidance = avoidance;
    this.headway = headway;
    this.aircraft = aircraft;
    hover = new HoverPlace(avoidance);
  }

  /** Begins a goal. */
  public void begin() {
    headway.begin();
  }

  /** Forgets the place where the vehicle hovers. */
  public void leavePlace() {
    hover.leave();
  }

  /**
   * Evades traffic on the way to a goal, unless the way leads straight up or down from or to the
   * ground.
   *
   * @param distanceM distance to the goal [m]
   * @param staysAt where the vehicle will stay; empty if the point only leads on
   */
  public void evade(
      GoalInformation goal,
      DoubleSupplier distanceM,
      List<NavigationPoint> points,
      Optional<Place> staysAt,
      StateInformation state) {
    boolean isOverGround =
        goal instanceof TakeOff
            || goal instanceof Landing && distanceM.getAsDouble() < KnownGround.REACH_M;
    if (!isOverGround) {
      evade(points, staysAt, state);
    }
  }

  private void evade(List<NavigationPoint> points, Optional<Place> end, StateInformation state) {
    if (aircraft.flies().getAsBoolean()) {
      Vehicle vehicle = Vehicle.of(state).orElseThrow();
      own(points).ifPresent(point -> avoidance.evade(vehicle, state, point, end));
    }
  }

  /**
   * Keeps the vehicle from climbing or descending into what is above or below.
   *
   * @param touchesDown whether it is touching down, or has
   * @return why to give the goal up; empty if there is no reason
   */
  public Optional<String> guard(
      GoalInformation goal,
      List<NavigationPoint> points,
      boolean touchesDown,
      StateInformation state) {
    if (!(goal instanceof Landing landing)) {
      return guard(goal.uid(), points, lastGround(), state);
    }
    Place place = Place.of(landing);
    Optional<String> why =
        guard(goal.uid(), points, new KnownGround(Optional.of(place), true, touchesDown), state);
    if (avoidance.isHeldUp()) {
      double upM = Vehicle.of(state).orElseThrow().place().upM().orElse(0.0);
      evade(points, Optional.of(place.at(upM)), state); // it hovers above the position
    }
    return why;
  }

  private Optional<String> guard(
      String uid, List<NavigationPoint> points, KnownGround below, StateInformation state) {
    Vehicle vehicle = Vehicle.of(state).orElseThrow();
    return own(points).flatMap(point -> avoidance.guard(uid, vehicle, state, point, below));
  }

  private KnownGround lastGround() {
    return new KnownGround(aircraft.stoodAt().get(), false, false);
  }

  /** Why to give the goal up for lack of headway; empty if there is no reason. */
  public Optional<String> lackOfHeadway(
      GoalInformation goal, List<NavigationPoint> points, StateInformation state) {
    if (goal instanceof TakeOff) {
      headway.leave();
      return Optional.empty();
    }
    return lackOfHeadway(points, state);
  }

  private Optional<String> lackOfHeadway(List<NavigationPoint> points, StateInformation state) {
    Optional<NavigationPoint> point = own(points);
    if (point.isEmpty()
        || !aircraft.isAeroplane().getAsBoolean()
        || !aircraft.flies().getAsBoolean()) {
      headway.leave();
      return Optional.empty();
    }
    Vehicle vehicle = Vehicle.of(state).orElseThrow();
    return headway.step(vehicle, state, point.get().point(), aircraft.headwayTimeS().getAsDouble());
  }

  /**
   * Points of a vehicle that holds its position: those given, or those that evade traffic.
   *
   * @param held points at which it holds; empty if it hovers without any
   */
  public List<NavigationPoint> hovering(List<NavigationPoint> held, StateInformation state) {
    boolean flies = aircraft.flies().getAsBoolean();
    if (flies) {
      Vehicle vehicle = Vehicle.of(state).orElseThrow();
      own(held).ifPresent(point -> avoidance.hover(vehicle, state, point));
    }
    List<NavigationPoint> points = held.isEmpty() && flies ? hover.points(state) : held;
    guard("", points, lastGround(), state); // it waits at its altitude
    lackOfHeadway(points, state);
    return points;
  }

  private static Optional<NavigationPoint> own(List<NavigationPoint> points) {
    return points.stream().filter(point -> point.subsystem().equals("VEHICLE")).findFirst();
  }
}
