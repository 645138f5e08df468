package org.u2sa.scenarios.vrx;

import java.util.ArrayList;
import java.util.List;
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
import org.u2sa.scenarios.vrx.sight.MarkerGate;

/**
 * Passes the gates of a {@link GateCourse}, around obstacles: first the first one, then always the
 * nearest that lies ahead of the last one passed. Without a gate in sight it continues for a short
 * distance, then turns in place.
 */
final class GateCourseState implements PlannerState {
  private static final double UNKNOWN_M =
      1.0e6; // assumed distance of a course that is still unseen
  private static final double SAME_M = 6.0; // a gate this close to a passed one is the same
  private static final double REACH_M = 75.0; // maximum distance to the next gate
  private static final double BEFORE_M =
      6.0; // distance before the gate of the place on its axis to approach first
  private static final double BEYOND_M = 4.0;
  private static final double THROUGH_SHARE =
      0.3; // fraction of the width, from the middle, that is a clear passage
  private static final double ON_M = 25.0; // beyond the last gate, searching
  private static final double WITHIN_M = 1.5;
  private static final double TURN_RAD = 0.4; // ahead of the heading, to turn in place
  private static final double GIVE_UP_S = 60.0;

  private final PlannerView surroundings;
  private final List<MarkerGate> passed = new ArrayList<>();
  private Optional<Point> before = Optional.empty(); // position at the last state
  private Optional<Point> target = Optional.empty(); // direction of the current approach
  private long seenMicros; // when a next gate was last known

  GateCourseState(PlannerView surroundings) {
    this.surroundings = surroundings;
  }

  @Override
  public Class<? extends GoalInformation> goalClass() {
    return GateCourse.class;
  }

  @Override
  public void enter(Pursuit pursuit) {
    surroundings.begin();
    passed.clear();
    before = Optional.empty();
    target = Optional.empty();
    seenMicros = micros(pursuit.state());
  }

  @Override
  public double distanceM(GoalInformation goal, StateInformation state) {
    Point here = surroundings.here(state);
    return next((GateCourse) goal, state)
        .map(gate -> gate.middle().flatDistanceTo(here))
        .orElse(UNKNOWN_M);
  }

  private static long micros(StateInformation state) {
    return state.timestamp().orElseThrow();
  }

  @Override
  public Plan plan(Pursuit pursuit) {
    GateCourse goal = (GateCourse) pursuit.goal();
    StateInformation state = pursuit.state();
    Point here = surroundings.here(state);
    Optional<MarkerGate> next = next(goal, state);
    if (next.isPresent() && before.isPresent() && next.get().isPassed(before.get(), here)) {
      passed.add(next.get());
      target = Optional.empty();
      if (next.get().place() == MarkerGate.Place.LAST) {
        return new Plan(List.of(), Plan.Progress.COMPLETED, passed.size() + " gates passed");
      }
      next = next(goal, state);
    }
    before = Optional.of(here);
    if (next.isPresent()) {
      seenMicros = micros(state);
      return towards(pursuit, through(next.get(), here), goal.speed());
    }
    return search(pursuit, here, goal.speed());
  }

  private Optional<MarkerGate> next(GateCourse goal, StateInformation state) {
    Optional<MarkerGate> last =
        passed.isEmpty() ? Optional.empty() : Optional.of(passed.get(passed.size() - 1));
    Point from = last.map(MarkerGate::middle).orElseGet(() -> surroundings.here(state));
    return gates(goal, state).stream()
        .filter(gate -> last.isPresent() != (gate.place() == MarkerGate.Place.FIRST))
        .filter(gate -> last.map(old -> old.aheadM(gate.middle()) < -SAME_M).orElse(true))
        .filter(
            gate ->
                passed.stream()
                    .allMatch(old -> old.middle().flatDistanceTo(gate.middle()) > SAME_M))
        .filter(gate -> gate.middle().flatDistanceTo(from) < REACH_M)
        .min(
            (a, b) ->
                Double.compare(a.middle().flatDistanceTo(from), b.middle().flatDistanceTo(from)));
  }

  private List<MarkerGate> gates(GateCourse goal, StateInformation state) {
    List<MarkerGate.Port> ports = new ArrayList<>();
    List<Point> starboards = new ArrayList<>();
    for (ObjectDescription object : surroundings.objects()) {
      int type = goal.objectTypes().indexOf(object.objectType());
      Point at = type < 0 ? Point.ORIGIN : surroundings.centre(object, state);
      if (type == MarkerGate.Place.values().length) {
        starboards.add(at);
      } else if (type >= 0) {
        ports.add(new MarkerGate.Port(at, MarkerGate.Place.values()[type]));
      }
    }
    return MarkerGate.among(ports, starboards);
  }

  /** A point beyond the gate if a straight path leads through it, otherwise in front of it. */
  private static Point through(MarkerGate gate, Point here) {
    double ahead = gate.aheadM(here);
    double aside = gate.asideM(here) * BEYOND_M / (ahead + BEYOND_M);
    boolean isThrough = ahead > 0.0 && Math.abs(aside) < THROUGH_SHARE * gate.widthM();
    return gate.beyond(isThrough ? BEYOND_M : -BEFORE_M);
  }

  private Plan towards(Pursuit pursuit, Point place, double speedMps) {
    if (target.map(old -> old.flatDistanceTo(place) > 1.0).orElse(true)) {
      target = Optional.of(place);
      surroundings.begin();
    }
    PlannerView.Step step =
        surroundings.towards(pursuit, target.get(), WITHIN_M, OptionalDouble.of(speedMps));
    return step.givenUp()
        .map(why -> new Plan(List.of(), Plan.Progress.ABANDONED, "given up: " + why))
        .orElseGet(() -> Plan.underWay(List.of(step.point())));
  }

  private Plan search(Pursuit pursuit, Point here, double speedMps) {
    double unseenS = Clock.seconds(micros(pursuit.state()) - seenMicros);
    if (unseenS > GIVE_UP_S) {
      return new Plan(
          List.of(),
          Plan.Progress.ABANDONED,
          "abandoned: no gate seen after " + passed.size() + " gates");
    }
    if (!passed.isEmpty()) {
      MarkerGate last = passed.get(passed.size() - 1);
      if (here.flatDistanceTo(last.middle()) < ON_M) {
        return towards(pursuit, last.beyond(ON_M + WITHIN_M), speedMps);
      }
    }
    return Plan.underWay(List.of(NavigationPoint.at(Point.ORIGIN).turn(TURN_RAD)));
  }
}
