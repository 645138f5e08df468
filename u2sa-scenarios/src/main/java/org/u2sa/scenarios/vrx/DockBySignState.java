package org.u2sa.scenarios.vrx;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
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
import org.u2sa.scenarios.vrx.sight.SeenSigns;

/**
 * Executes a {@link DockBySign}: waits near the light buoy until the sequence is known, circles the
 * dock until the signs are in sight, lines up with the bay, enters, stays, and reverses out.
 */
final class DockBySignState implements PlannerState {
  private enum Phase {
    SCANS,
    LOOKS,
    LINES_UP,
    ENTERS,
    LEAVES
  }

  private static final double UNKNOWN_M = 1.0e6;
  private static final double LIGHT_M = 10.0; // distance from the light buoy while reading it
  private static final double ROUND_M = 24.0; // radius around the dock's middle
  private static final double STEP_RAD = 0.5; // step ahead on the way around the dock
  private static final double READ_M = 16.0; // distance in front of the middle of the signs
  private static final double READ_WITHIN_M = 3.0;
  private static final double READ_S = 4.0; // time there, for accurate positions
  private static final double LINE_UP_M = 15.0; // distance in front of a sign
  private static final double BERTH_M = 4.2;
  private static final double OUT_M = 9.2;
  private static final double ALIGNED_M = 0.25;
  private static final double ALIGNED_RAD = Math.toRadians(3.0);
  private static final double AHEAD_M = 2.0; // look-ahead along the axis
  private static final double WITHIN_M = 0.5; // tolerance at the berth, along the axis
  private static final double SLOW_MPS = 0.8;
  private static final double NEAR_MPS = 1.5; // near the dock, so as not to overshoot
  private static final double TURN_RAD = 0.4; // ahead of the heading, to turn in place
  private static final int SIGNS = 3;

  private final PlannerView surroundings;
  private Phase phase = Phase.SCANS;
  private Optional<Point> inwards = Optional.empty(); // unit vector into the bays
  private Optional<Point> sign = Optional.empty(); // sign of the bay
  private long readMicros; // since when in front of the signs
  private long thereMicros; // since when in the bay

  DockBySignState(PlannerView surroundings) {
    this.surroundings = surroundings;
  }

  @Override
  public Class<? extends GoalInformation> goalClass() {
    return DockBySign.class;
  }

  @Override
  public void enter(Pursuit pursuit) {
    surroundings.begin();
    phase = Phase.SCANS;
    inwards = Optional.empty();
    sign = Optional.empty();
    readMicros = Long.MAX_VALUE;
    thereMicros = Long.MAX_VALUE;
  }

  @Override
  public double distanceM(GoalInformation goal, StateInformation state) {
    return places(Docking.LIGHT, state).stream()
        .mapToDouble(place -> place.flatDistanceTo(surroundings.here(state)))
        .min()
        .orElse(UNKNOWN_M);
  }

  @Override
  public Plan plan(Pursuit pursuit) {
    DockBySign goal = (DockBySign) pursuit.goal();
    StateInformation state = pursuit.state();
    Map<String, Point> signs = SeenSigns.of(surroundings, state);
    face(signs, surroundings.here(state));
    if (phase == Phase.SCANS && !goal.sequence().isEmpty()) {
      next(Phase.LOOKS);
    }
    if (phase == Phase.LOOKS && hasRead(signs, state)) {
      if (!signs.containsKey(goal.sign())) {
        return abandoned("no bay has a " + goal.sign() + ", but " + signs.keySet());
      }
      next(Phase.LINES_UP);
    }
    if (phase == Phase.LINES_UP || phase == Phase.ENTERS) {
      sign = Optional.ofNullable(signs.get(goal.sign())).or(() -> sign);
    }
    return switch (phase) {
      case SCANS -> scan(pursuit);
      case LOOKS -> look(pursuit, signs);
      case LINES_UP, ENTERS, LEAVES -> dock(pursuit, goal);
    };
  }

  private void next(Phase following) {
    phase = following;
    surroundings.begin();
  }

  private static Plan abandoned(String why) {
    return new Plan(List.of(), Plan.Progress.ABANDONED, "abandoned: " + why);
  }

  private List<Point> places(String type, StateInformation state) {
    List<Point> places = new ArrayList<>();
    for (ObjectDescription object : surroundings.objects()) {
      if (object.objectType().equals(type)) {
        places.add(surroundings.centre(object, state));
      }
    }
    return places;
  }

  /**
   * The bays lie in front of the signs, perpendicular to their row, on the side from which the
   * signs are seen.
   */
  private void face(Map<String, Point> signs, Point here) {
    if (signs.size() < 2 || phase == Phase.ENTERS || phase == Phase.LEAVES) {
      return;
    }
    Point first = signs.values().iterator().next();
    Point second = first;
    for (Point a : signs.values()) { // the two farthest apart
      for (Point b : signs.values()) {
        if (a.flatDistanceTo(b) > first.flatDistanceTo(second)) {
          first = a;
          second = b;
        }
      }
    }
    Point across = second.minus(first).times(1.0 / first.flatDistanceTo(second));
    Point square = Point.of(-across.y(), across.x(), 0.0);
    Point forward = inwards.orElse(first.minus(here));
    inwards = Optional.of(square.dot(forward) > 0.0 ? square : square.times(-1.0));
  }

  private Plan scan(Pursuit pursuit) {
    StateInformation state = pursuit.state();
    Point here = surroundings.here(state);
    List<Point> lights = places(Docking.LIGHT, state);
    if (lights.isEmpty()) {
      return turn();
    }
    Point way = lights.get(0).minus(here);
    double distance = lights.get(0).flatDistanceTo(here);
    return distance > LIGHT_M
        ? towards(
            pursuit, here.plus(way.times(1.0 - (LIGHT_M - 2.0) / distance)), OptionalDouble.empty())
        : Plan.underWay(List.of());
  }

  private boolean hasRead(Map<String, Point> signs, StateInformation state) {
    long now = state.timestamp().orElseThrow();
    boolean isThere =
        signs.size() == SIGNS
            && readPlace(signs).flatDistanceTo(surroundings.here(state)) < READ_WITHIN_M;
    readMicros = isThere ? Math.min(readMicros, now) : Long.MAX_VALUE;
    return isThere && Clock.seconds(now - readMicros) >= READ_S;
  }

  private Point readPlace(Map<String, Point> signs) {
    return middle(List.copyOf(signs.values())).minus(inwards.orElseThrow().times(READ_M));
  }

  private Plan look(Pursuit pursuit, Map<String, Point> signs) {
    StateInformation state = pursuit.state();
    if (inwards.isPresent() && !signs.isEmpty()) {
      return towards(pursuit, readPlace(signs), OptionalDouble.of(NEAR_MPS));
    }
    List<Point> blocks = places(Docking.BLOCK, state);
    if (blocks.isEmpty()) {
      return turn();
    }
    Point middle = middle(blocks);
    Point from = surroundings.here(state).minus(middle);
    double at = Math.atan2(from.y(), from.x()) + STEP_RAD;
    return towards(
        pursuit,
        middle.plus(Point.of(ROUND_M * Math.cos(at), ROUND_M * Math.sin(at), 0.0)),
        OptionalDouble.empty());
  }

  private static Point middle(List<Point> places) {
    Point sum = Point.ORIGIN;
    for (Point each : places) {
      sum = sum.plus(each);
    }
    return sum.times(1.0 / places.size());
  }

  private Plan dock(Pursuit pursuit, DockBySign goal) {
    StateInformation state = pursuit.state();
    Point axis = inwards.orElseThrow();
    Point way = sign.orElseThrow().minus(surroundings.here(state));
    double toGo = axis.dot(way); // to the sign
    double aside = Math.abs(axis.x() * way.y() - axis.y() * way.x());
    double turn =
        Math.IEEEremainder(
            Math.atan2(axis.y(), axis.x()) - state.psi().orElseThrow(), 2.0 * Math.PI);
    boolean isAligned = aside < ALIGNED_M && Math.abs(turn) < ALIGNED_RAD;
    if (phase == Phase.LINES_UP && isAligned && Math.abs(toGo - LINE_UP_M) < 1.0) {
      next(Phase.ENTERS);
    }
    if (phase == Phase.ENTERS && Math.abs(toGo - BERTH_M) < WITHIN_M) {
      thereMicros = Math.min(thereMicros, state.timestamp().orElseThrow());
      if (Clock.seconds(state.timestamp().orElseThrow() - thereMicros) >= goal.duration()) {
        next(Phase.LEAVES);
      }
    }
    if (phase == Phase.LEAVES && toGo > OUT_M) {
      return new Plan(List.of(), Plan.Progress.COMPLETED, "docked and left");
    }
    if (phase == Phase.LINES_UP && Math.hypot(way.x(), way.y()) > LINE_UP_M + 8.0) {
      return towards(pursuit, sign.get().minus(axis.times(LINE_UP_M)), OptionalDouble.of(NEAR_MPS));
    }
    double wanted =
        phase == Phase.LINES_UP ? LINE_UP_M : phase == Phase.ENTERS ? BERTH_M : OUT_M + 1;
    double rest = toGo - wanted;
    double step = isAligned ? Math.max(-AHEAD_M, Math.min(AHEAD_M, rest)) : Math.signum(rest) * 0.2;
    double ahead = phase == Phase.LINES_UP ? rest : step;
    Point aim = surroundings.here(state).plus(way).minus(axis.times(toGo - ahead));
    return Plan.underWay(List.of(surroundings.straight(state, aim).speed(SLOW_MPS).turn(turn)));
  }

  private Plan towards(Pursuit pursuit, Point place, OptionalDouble speedMps) {
    PlannerView.Step step = surroundings.towards(pursuit, place, 1.0, speedMps);
    return step.givenUp()
        .map(DockBySignState::abandoned)
        .orElseGet(() -> Plan.underWay(List.of(step.point())));
  }

  private static Plan turn() {
    return Plan.underWay(List.of(NavigationPoint.at(Point.ORIGIN).turn(TURN_RAD)));
  }
}
