package org.u2sa.planning;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.avoidance.Avoidance;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;

/**
 * Way around obstacles and traffic for states that otherwise follow lines; absent without a route
 * planner.
 */
final class Detour {
  private static final double SMALL_RAD = Math.toRadians(20.0);
  private static final double ASTERN_RAD = Math.toRadians(150.0);
  private static final double NEAR_M = 10.0; // from a target, where the straight way is short
  private static final double TURN_REACH = 2.5; // of a turn back, ahead [turning radii]

  private final Avoidance avoidance;
  private boolean isTaken;

  Detour(Avoidance avoidance) {
    this.avoidance = avoidance;
  }

  void begin() {
    isTaken = false;
    avoidance.begin();
  }

  /** Whether the planner avoids anything. */
  boolean isPossible() {
    return avoidance.isOn();
  }

  /** Whether the vehicle is an aircraft that can stop, which looks above and below itself. */
  boolean isOfAircraftThatStops(StateInformation state) {
    return avoidance.guards(state);
  }

  /**
   * Whether a straight way of such an aircraft leads into something that stands, or the ground, or
   * out of the corridors.
   */
  boolean isBlocked(Vehicle vehicle, StateInformation state, Place to) {
    return avoidance.straight().isBlocked(vehicle, state, to)
        || avoidance.straight().isGroundBetween(vehicle, state, to)
        || avoidance.straight().leavesCorridors(vehicle, state, vehicle.place(), to);
  }

  /** Whether the straight way of a vehicle on a surface leads to something that stands or moves. */
  boolean isOccupied(Vehicle vehicle, StateInformation state, Place to) {
    return avoidance.isOn()
        && (avoidance.straight().comesTraffic(vehicle, state, to)
            || avoidance.straight().room(vehicle, state, to).isOccupied());
  }

  /** Whether such a vehicle would soon run into something, or something moves on its way. */
  boolean isBlockedSoon(Vehicle vehicle, StateInformation state, Place to) {
    return avoidance.isOn()
        && !avoidance.guards(state)
        && (avoidance.straight().comesTraffic(vehicle, state, to)
            || avoidance.straight().room(vehicle, state, to).isBlockedSoon());
  }

  /**
   * Speed of a vehicle on a surface that moves straight to where it stops [m/s], at most the wanted
   * one; for other vehicles, and without a route planner, the wanted one if there is one.
   *
   * @param berths whether it moves along the straight way to a berth
   */
  OptionalDouble straightMps(
      Vehicle vehicle, StateInformation state, Avoidance.Wanted wanted, boolean berths) {
    return isOnSurface(state)
        ? OptionalDouble.of(avoidance.straight().straightMps(vehicle, state, wanted, berths))
        : wanted.speedMps();
  }

  /** Slows a step of a vehicle on a surface down so that the vehicle stops at its target. */
  void stopAt(NavigationPoint step, Vehicle vehicle, StateInformation state, Avoidance.Wanted to) {
    if (isOnSurface(state) && step.speed().isPresent()) {
      double slowMps = avoidance.straight().stoppableMps(vehicle, to);
      step.speed(Math.min(step.speed().getAsDouble(), slowMps));
    }
  }

  private boolean isOnSurface(StateInformation state) {
    return avoidance.isOn() && avoidance.stops() && !avoidance.guards(state);
  }

  /** Minimum turn radius of a vehicle that can stop [m]; 0 if it turns in place. */
  double turnRadiusM(Vehicle vehicle) {
    return avoidance.stops() ? avoidance.turnRadiusM(vehicle) : 0.0;
  }

  /**
   * Whether something may be on the straight way of a vehicle on a surface to a position, or there
   * is no room to turn towards it and it does not lie astern.
   */
  boolean isReturnBlocked(Vehicle vehicle, StateInformation state, Place place) {
    if (!avoidance.isOn() || avoidance.guards(state)) {
      return false;
    }
    return avoidance.isBlind(vehicle)
        || isOccupied(vehicle, state, place)
        || turnRadiusM(vehicle) == 0.0
            && !hasRoomToTurn(vehicle, state, bearingRad(vehicle, place))
            && !goesAstern(vehicle, state, place);
  }

  /** Whether a vehicle that turns in place reverses to a position astern, lacking room to turn. */
  boolean goesAstern(Vehicle vehicle, StateInformation state, Place place) {
    double bearingRad = bearingRad(vehicle, place);
    return avoidance.backwardsMps() > 0.0
        && turnRadiusM(vehicle) == 0.0
        && Math.abs(bearingRad) > ASTERN_RAD
        && !hasRoomToTurn(vehicle, state, bearingRad);
  }

  /** Leads there in reverse. */
  void leadAstern(NavigationPoint point) {
    double mps = Math.min(point.speed().orElse(Double.MAX_VALUE), avoidance.backwardsMps());
    point.backwards(true).speed(mps);
  }

  private static double bearingRad(Vehicle vehicle, Place place) {
    Point way = vehicle.body(vehicle.nedOf(place));
    return Math.atan2(way.y(), way.x());
  }

  /**
   * Whether a vehicle on a surface can turn where it is; small turns always count as possible,
   * because it may be berthed.
   *
   * @param turnRad turn [rad], positive to the right
   */
  boolean hasRoomToTurn(Vehicle vehicle, StateInformation state, double turnRad) {
    return !avoidance.isOn()
        || avoidance.guards(state)
        || Math.abs(turnRad) < SMALL_RAD
        || avoidance.straight().room(vehicle, state, vehicle.place()).isEnoughToTurn(turnRad);
  }

  /** Whether such a vehicle can turn on its straight way to a position. */
  boolean hasRoomToTurnOnWay(Vehicle vehicle, StateInformation state, Place to, double turnRad) {
    return !avoidance.isOn()
        || avoidance.guards(state)
        || Math.abs(turnRad) < SMALL_RAD
        || avoidance.straight().room(vehicle, state, to).isEnoughToTurnOnWay(turnRad);
  }

  /** Whether something, or the ground, blocks the straight way to a position. */
  boolean isHindered(Vehicle vehicle, StateInformation state, Place to) {
    return isObstructed(vehicle, state, to)
        || avoidance.isOn() && avoidance.straight().isGroundBetween(vehicle, state, to);
  }

  /** Likewise, of a way that leads to the ground. */
  boolean isObstructed(Vehicle vehicle, StateInformation state, Place to) {
    return avoidance.isOn() && avoidance.straight().isHindered(vehicle, state, to);
  }

  /** Whether ground is too high at a place of a circle about a centre of the same altitude. */
  boolean isGroundAt(Vehicle vehicle, StateInformation state, Place place, Place centre) {
    return avoidance.isOn() && avoidance.straight().isGroundAt(vehicle, state, place, centre);
  }

  /** Whether traffic comes close on the straight way to a position. */
  boolean comesTraffic(Vehicle vehicle, StateInformation state, Place to) {
    return avoidance.isOn() && avoidance.straight().comesTraffic(vehicle, state, to);
  }

  /** Whether an obstacle blocks a straight descent to a position on the ground. */
  boolean blocksDescent(Vehicle vehicle, StateInformation state, Place from, Place to) {
    return avoidance.isOn() && avoidance.straight().blocksDescent(vehicle, state, from, to);
  }

  /** Whether something above or below held the vehicle up at the last state. */
  boolean isHeldUp() {
    return avoidance.isHeldUp();
  }

  /** Whether a route to the target of the last {@link #step} is known. */
  boolean hasRoute() {
    return avoidance.remainingM().isPresent();
  }

  /**
   * The next step around an obstruction; empty if the straight way is free. A vehicle that has to
   * turn first needs a free way ahead, too, and then keeps to its route until it has turned. An
   * aircraft that can stop keeps to it until it is near: it could not stop on a straight way in
   * time.
   *
   * @param isTurned whether the vehicle already moves on the straight way
   */
  Optional<Plan> ifHindered(
      Vehicle vehicle, StateInformation state, Avoidance.Wanted wanted, boolean isTurned) {
    Point to = vehicle.nedOf(wanted.target());
    double reachM = turnReachM(vehicle);
    boolean turns = reachM > 0.0 && !isTurned;
    boolean isFar = isOfAircraftThatStops(state) ? Math.hypot(to.x(), to.y()) > NEAR_M : turns;
    boolean isHindered =
        isTaken && isFar
            || isHindered(vehicle, state, wanted.target())
            || turns && isHinderedAhead(vehicle, state, reachM, wanted.target());
    if (isHindered != isTaken) {
      begin();
      isTaken = isHindered;
    }
    return isHindered ? Optional.of(step(vehicle, state, wanted)) : Optional.empty();
  }

  /**
   * How far ahead a turn back leads, at most [m]; 0 for vehicles that turn in place, and without a
   * route planner.
   */
  double turnReachM(Vehicle vehicle) {
    return avoidance.isOn() ? TURN_REACH * avoidance.turnRadiusM(vehicle) : 0.0;
  }

  private boolean isHinderedAhead(
      Vehicle vehicle, StateInformation state, double distanceM, Place target) {
    double course = vehicle.courseRad();
    Place ahead = vehicle.place().moved(distanceM * Math.cos(course), distanceM * Math.sin(course));
    OptionalDouble upM = target.upM();
    Place to = upM.isPresent() ? ahead.at(upM.getAsDouble()) : ahead;
    return avoidance.straight().isHindered(vehicle, state, to)
        || avoidance.straight().isGroundAhead(vehicle, state, vehicle.place(), to);
  }

  /** Whether a place is closed to a vehicle that cannot stop. */
  boolean isClosedAt(Vehicle vehicle, StateInformation state, Place place) {
    return avoidance.isOn() && avoidance.straight().isClosedAt(vehicle, state, place);
  }

  /** Whether the fence in force leaves room to climb to a place. */
  boolean isInsideFence(Vehicle vehicle, StateInformation state, Place place) {
    return avoidance.isInsideFence(vehicle, state, place);
  }

  /**
   * Whether a straight way from one position to another is closed: ground is too high, or it leaves
   * the corridors.
   */
  boolean isClosed(Vehicle vehicle, StateInformation state, Place from, Place to) {
    return avoidance.isOn()
        && (avoidance.straight().isGroundAhead(vehicle, state, from, to)
            || avoidance.straight().leavesCorridors(vehicle, state, from, to));
  }

  /** The next step of the planned route; ends the pursuit if there is none. */
  Plan step(Vehicle vehicle, StateInformation state, Avoidance.Wanted wanted) {
    Avoidance.Step step = avoidance.step(vehicle, state, wanted);
    List<NavigationPoint> points = List.of(step.point(vehicle));
    return step.givenUp()
        .map(reason -> new Plan(points, Plan.Progress.ABANDONED, "given up: " + reason))
        .orElseGet(() -> Plan.underWay(points));
  }
}
