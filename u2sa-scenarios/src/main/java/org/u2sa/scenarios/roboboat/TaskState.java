package org.u2sa.scenarios.roboboat;

import java.util.Locale;
import java.util.OptionalDouble;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.marine.Colour;
import org.u2sa.planning.PlannerState;
import org.u2sa.planning.PlannerView;
import org.u2sa.planning.Pursuit;

/** Common part of all tasks at a station: finding the station and its objects. */
abstract class TaskState implements PlannerState {
  final PlannerView surroundings;

  TaskState(PlannerView surroundings) {
    this.surroundings = surroundings;
  }

  @Override
  public double distanceM(GoalInformation goal, StateInformation state) {
    BoatTask task = (BoatTask) goal;
    double way = away(station(task, state), state);
    return TaskChoice.costS(task, way, surroundings.missionS());
  }

  /** The station on the planner's plane. */
  Point station(BoatTask goal, StateInformation state) {
    return surroundings.onPlane(ReferenceFrame.GLOBAL, goal.place(), state);
  }

  /** Horizontal distance of a position on the plane [m]. */
  double away(Point place, StateInformation state) {
    Point here = surroundings.here(state);
    return Math.hypot(place.x() - here.x(), place.y() - here.y());
  }

  /** The way to a position, around obstacles. */
  PlannerView.Step towards(Pursuit pursuit, Point place, double thresholdM, double speedMps) {
    return surroundings.towards(pursuit, place, thresholdM, OptionalDouble.of(speedMps));
  }

  /** Name of a kind of object, such as "orange buoy". */
  static String name(Colour colour, String kind) {
    return colour.name().toLowerCase(Locale.ROOT) + " " + kind;
  }
}
