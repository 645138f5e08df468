package org.u2sa.scenarios.vrx;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.planning.Plan;
import org.u2sa.planning.PlannerState;
import org.u2sa.planning.PlannerView;
import org.u2sa.planning.Pursuit;

/**
 * Circles the mapped objects of a {@link CircleObjects}, nearest first, on tangents from one to the
 * next, and around the others.
 */
final class CircleState implements PlannerState {
  private static final double UNKNOWN_M =
      1.0e6; // assumed distance of objects that are still unseen
  private static final double FULL_RAD = Math.toRadians(385.0); // a circle, with overlap
  private static final double LEAD_RAD = Math.toRadians(50.0); // look-ahead angle
  private static final double CIRCLING_MPS = 2.5;
  private static final double MARGIN_M = 0.5; // margin of the distance on a circle
  private static final double OTHER_SHARE = 0.7; // clearance, per radius
  private static final double BEYOND_M = 2.0; // clearance of the point beside an avoided object
  private static final double FULL_SPEED_M = 8.0; // distance to a point passed at speed
  private static final double GIVE_UP_S = 60.0; // time without any object

  private final PlannerView surroundings;
  private final Set<String> done = new TreeSet<>();
  private String circled = ""; // UID of the object being circled
  private double bearingRad; // bearing from the object at the last state
  private double sweptRad; // angle turned in the right direction within the distance
  private long enteredMicros;

  CircleState(PlannerView surroundings) {
    this.surroundings = surroundings;
  }

  @Override
  public Class<? extends GoalInformation> goalClass() {
    return CircleObjects.class;
  }

  @Override
  public void enter(Pursuit pursuit) {
    done.clear();
    circled = "";
    enteredMicros = pursuit.state().timestamp().orElseThrow();
  }

  @Override
  public double distanceM(GoalInformation goal, StateInformation state) {
    return next((CircleObjects) goal, state)
        .map(object -> length(way(object, state)))
        .orElse(UNKNOWN_M);
  }

  @Override
  public Plan plan(Pursuit pursuit) {
    CircleObjects goal = (CircleObjects) pursuit.goal();
    StateInformation state = pursuit.state();
    Optional<ObjectDescription> next = next(goal, state);
    if (next.isEmpty()) {
      return withoutNext(state);
    }
    Point way = way(next.get(), state);
    double sign = goal.clockwise().contains(next.get().objectType()) ? 1.0 : -1.0;
    double bearing = Math.atan2(-way.y(), -way.x());
    boolean isOnIt = next.get().uid().equals(circled) && length(way) < goal.within() - MARGIN_M;
    double turn = Math.IEEEremainder(bearing - bearingRad, 2.0 * Math.PI);
    sweptRad = isOnIt ? sweptRad + sign * turn : 0.0;
    bearingRad = bearing;
    circled = next.get().uid();
    if (sweptRad >= FULL_RAD) {
      done.add(circled);
      return plan(pursuit);
    }
    double tangent = Math.acos(Math.min(1.0, goal.radius() / Math.max(1e-3, length(way))));
    double at = bearing + sign * Math.max(LEAD_RAD, tangent);
    Point aim = way.plus(Point.of(goal.radius() * Math.cos(at), goal.radius() * Math.sin(at), 0.0));
    Point around = around(goal, state, aim);
    double longer = isOnIt ? 1.0 : Math.max(1.0, FULL_SPEED_M / Math.max(1e-3, length(around)));
    NavigationPoint point = to(around.times(longer), state);
    return Plan.underWay(List.of(isOnIt ? point.speed(CIRCLING_MPS) : point));
  }

  private Plan withoutNext(StateInformation state) {
    if (!done.isEmpty()) {
      return new Plan(List.of(), Plan.Progress.COMPLETED, done.size() + " circled");
    }
    double sinceS = Clock.seconds(state.timestamp().orElseThrow() - enteredMicros);
    return sinceS > GIVE_UP_S
        ? new Plan(List.of(), Plan.Progress.ABANDONED, "abandoned: nothing to circle was seen")
        : Plan.underWay(List.of());
  }

  /** The object being circled, or the nearest one not circled yet. */
  private Optional<ObjectDescription> next(CircleObjects goal, StateInformation state) {
    Comparator<ObjectDescription> order =
        Comparator.comparingDouble(
            object -> object.uid().equals(circled) ? 0.0 : length(way(object, state)));
    return surroundings.objects().stream()
        .filter(
            object ->
                goal.clockwise().contains(object.objectType())
                    || goal.anticlockwise().contains(object.objectType()))
        .filter(object -> !done.contains(object.uid()))
        .min(order);
  }

  /** From the vehicle to an object: north, east [m]. */
  private Point way(ObjectDescription object, StateInformation state) {
    Point way = surroundings.centre(object, state).minus(surroundings.here(state));
    return Point.of(way.x(), way.y(), 0.0);
  }

  /** The direct path, or the path to a point beside the first object too close to it. */
  private Point around(CircleObjects goal, StateInformation state, Point way) {
    double length = length(way);
    ObjectDescription nearest = null;
    for (ObjectDescription object : surroundings.objects()) {
      Point other = way(object, state);
      if (!object.uid().equals(circled)
          && length(aside(other, way)) < clearance(object, goal)
          && along(other, way) > 0.0
          && along(other, way) < length
          && (nearest == null || length(other) < length(way(nearest, state)))) {
        nearest = object;
      }
    }
    if (nearest == null) {
      return way;
    }
    Point other = way(nearest, state);
    Point off = aside(other, way);
    double share = (clearance(nearest, goal) + BEYOND_M) / Math.max(1e-6, length(off));
    return other.plus(off.times(share));
  }

  private static double clearance(ObjectDescription object, CircleObjects goal) {
    return goal.avoided().contains(object.objectType())
        ? goal.clearance()
        : OTHER_SHARE * goal.radius();
  }

  private static double along(Point other, Point way) {
    return (other.x() * way.x() + other.y() * way.y()) / Math.max(1e-6, length(way));
  }

  /** Vector from a point to the nearest point of a line. */
  private static Point aside(Point other, Point way) {
    double share = along(other, way) / Math.max(1e-6, length(way));
    return way.times(share).minus(other);
  }

  private NavigationPoint to(Point way, StateInformation state) {
    return surroundings.straight(state, surroundings.here(state).plus(way));
  }

  private static double length(Point level) {
    return Math.hypot(level.x(), level.y());
  }
}
