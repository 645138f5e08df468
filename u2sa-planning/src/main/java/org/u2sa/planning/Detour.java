package org.u2sa.planning;

import java.util.List;
import java.util.Optional;
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
  private static final double NEAR_M = 10.0; // from a target, where the straight way is short

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

  /** Whether a straight way of such an aircraft leads into something that stands, or the ground. */
  boolean isBlocked(Vehicle vehicle, StateInformation state, Place to) {
    return avoidance.isBlocked(vehicle, state, to) || avoidance.isGroundBetween(vehicle, state, to);
  }

  /** Whether the straight way of a vehicle on a surface leads to something that stands or moves. */
  boolean isOccupied(Vehicle vehicle, StateInformation state, Place to) {
    return avoidance.isOn()
        && (avoidance.comesTraffic(vehicle, state, to)
            || avoidance.room(vehicle, state, to).isOccupied());
  }

  /** Whether such a vehicle would soon run into something, or something moves on its way. */
  boolean isBlockedSoon(Vehicle vehicle, StateInformation state, Place to) {
    return avoidance.isOn()
        && !avoidance.guards(state)
        && (avoidance.comesTraffic(vehicle, state, to)
            || avoidance.room(vehicle, state, to).isBlockedSoon());
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
        || avoidance.room(vehicle, state, vehicle.place()).isEnoughToTurn(turnRad);
  }

  /** Whether something, or the ground, blocks the straight way to a position. */
  boolean isHindered(Vehicle vehicle, StateInformation state, Place to) {
    return isObstructed(vehicle, state, to)
        || avoidance.isOn() && avoidance.isGroundBetween(vehicle, state, to);
  }

  /** Likewise, of a way that leads to the ground. */
  boolean isObstructed(Vehicle vehicle, StateInformation state, Place to) {
    return avoidance.isOn() && avoidance.isHindered(vehicle, state, to);
  }

  /** Whether ground is too high at a place of a circle about a centre of the same altitude. */
  boolean isGroundAt(Vehicle vehicle, StateInformation state, Place place, Place centre) {
    return avoidance.isOn() && avoidance.isGroundAt(vehicle, state, place, centre);
  }

  /** Whether traffic comes close on the straight way to a position. */
  boolean comesTraffic(Vehicle vehicle, StateInformation state, Place to) {
    return avoidance.isOn() && avoidance.comesTraffic(vehicle, state, to);
  }

  /** Whether an obstacle blocks a straight descent to a position on the ground. */
  boolean blocksDescent(Vehicle vehicle, StateInformation state, Place from, Place to) {
    return avoidance.isOn() && avoidance.blocksDescent(vehicle, state, from, to);
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
   * The next step around an obstruction; empty if the straight way is free. An aircraft that can
   * stop then keeps to its route until it is near: it could not stop on a straight way in time.
   */
  Optional<Plan> ifHindered(Vehicle vehicle, StateInformation state, Avoidance.Wanted wanted) {
    Point to = vehicle.nedOf(wanted.target());
    boolean goesOn = isTaken && isOfAircraftThatStops(state) && Math.hypot(to.x(), to.y()) > NEAR_M;
    boolean isHindered = goesOn || isHindered(vehicle, state, wanted.target());
    if (isHindered != isTaken) {
      begin();
      isTaken = isHindered;
    }
    return isHindered ? Optional.of(step(vehicle, state, wanted)) : Optional.empty();
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
