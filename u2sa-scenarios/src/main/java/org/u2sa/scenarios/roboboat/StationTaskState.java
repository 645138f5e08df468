package org.u2sa.scenarios.roboboat;

import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.Plan;
import org.u2sa.planning.PlannerView;
import org.u2sa.planning.Pursuit;

/**
 * A task at a station: the boat goes there around obstacles, works there, and returns when wind or
 * current has carried it off.
 */
abstract class StationTaskState extends TaskState {
  private static final double ARRIVED_M = 1.0;
  private static final double CARRIED_OFF_M = 2.5;
  private static final double WAY_MPS = 1.2;
  private static final double NEAR_M = 10.0; // radius around a station for its objects
  private static final double LIMIT_S = 200.0; // timeout of a task, including the approach

  private long enteredMicros; // Long.MIN_VALUE: not yet
  private boolean isThere;
  private long arrivedMicros; // Long.MIN_VALUE: not yet

  StationTaskState(PlannerView surroundings) {
    super(surroundings);
  }

  /** Resets the state for a new task. */
  abstract void begin(BoatTask task);

  /**
   * Next step at the station.
   *
   * @param sinceS time since the arrival [s]
   */
  abstract Plan work(BoatTask task, Pursuit pursuit, double sinceS);

  /** Whether the boat may be farther from the station now. */
  boolean isFree() {
    return false;
  }

  @Override
  public final void enter(Pursuit pursuit) {
    surroundings.begin();
    isThere = false;
    arrivedMicros = Long.MIN_VALUE;
    enteredMicros = Long.MIN_VALUE;
    begin((BoatTask) pursuit.goal());
  }

  @Override
  public final Plan plan(Pursuit pursuit) {
    BoatTask task = (BoatTask) pursuit.goal();
    StateInformation state = pursuit.state();
    if (enteredMicros == Long.MIN_VALUE) {
      enteredMicros = micros(state);
    }
    if (Clock.seconds(micros(state) - enteredMicros) > LIMIT_S) {
      return givenUp(String.format(Locale.ROOT, "not done within %.0f s", LIMIT_S));
    }
    Point station = station(task, state);
    double away = away(station, state);
    if (isThere && away > CARRIED_OFF_M && !isFree()) {
      isThere = false;
      surroundings.begin();
    }
    isThere |= away <= ARRIVED_M || isFree();
    if (isThere && arrivedMicros == Long.MIN_VALUE) {
      arrivedMicros = micros(state);
    }
    double sinceS =
        arrivedMicros == Long.MIN_VALUE ? 0.0 : Clock.seconds(micros(state) - arrivedMicros);
    if (isThere) {
      return work(task, pursuit, sinceS);
    }
    PlannerView.Step step = towards(pursuit, station, ARRIVED_M / 2.0, WAY_MPS);
    return step.givenUp()
        .map(StationTaskState::givenUp)
        .orElseGet(() -> Plan.underWay(List.of(step.point())));
  }

  static long micros(StateInformation state) {
    return state.timestamp().orElseThrow();
  }

  static Plan givenUp(String reason) {
    return new Plan(List.of(), Plan.Progress.ABANDONED, "given up: " + reason);
  }

  /** The object of a type nearest to a point, among those near the station. */
  final Optional<ObjectDescription> nearest(
      String type, Point to, BoatTask task, StateInformation state) {
    Point station = station(task, state);
    return surroundings.objects().stream()
        .filter(object -> object.objectType().equals(type))
        .filter(object -> surroundings.centre(object, state).flatDistanceTo(station) < NEAR_M)
        .min(
            Comparator.comparingDouble(
                object -> surroundings.centre(object, state).flatDistanceTo(to)));
  }

  /** Keeps station as far as the boat's thrust allows, with the given heading. */
  final NavigationPoint facing(BoatTask task, StateInformation state, double headingRad) {
    double turn = headingRad - state.psi().orElseThrow();
    return surroundings
        .straight(state, station(task, state))
        .turn(Math.IEEEremainder(turn, 2.0 * Math.PI));
  }

  /** Returns to the station stern first, even against wind and current from the side. */
  final Plan back(BoatTask task, StateInformation state, double speedMps) {
    NavigationPoint point = surroundings.straight(state, station(task, state));
    return Plan.underWay(List.of(point.backwards(true).speed(speedMps)));
  }

  /** Keeps station, facing the station's objects. */
  final Plan lookOut(BoatTask task, StateInformation state) {
    double heading = task.psi().orElse(state.psi().orElseThrow());
    return Plan.underWay(List.of(facing(task, state, heading)));
  }
}
