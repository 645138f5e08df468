package org.u2sa.scenarios.roboboat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.planning.Plan;
import org.u2sa.planning.PlannerView;
import org.u2sa.planning.Pursuit;

/**
 * Passes the gates of a {@link BuoyChannel} in order: always the nearest one ahead that has not
 * been passed. Far from it, it goes around obstacles to a place before the gate; otherwise it
 * follows the line through the middles of the gates.
 */
final class ChannelState extends TaskState {
  private static final double BEFORE_M = 4.0; // place before a gate at which it is on the axis
  private static final double CLEAR_M = 1.5; // from an object to a straight way
  private static final double READY_M = 2.0; // nearest to the gate at which it lines up
  private static final double LINED_UP_M = 0.5; // from the axis
  private static final double OFF_M = 2.0; // from the line between two gates
  private static final double FULL_SPEED_M =
      8.0; // distance of a point at which control does not slow down
  private static final double AHEAD_M = 2.2; // of the point on the line to steer to
  private static final double SAME_M = 2.0; // a gate this near one that was passed is the same
  private static final double BEHIND_M = 1.0; // a gate is still ahead
  private static final double REACH_M = 30.0; // to the next gate
  private static final double BLIND_M = 25.0; // straight on without a gate in sight
  private static final double AT_END_M = 5.0; // from the buoy at the end
  private static final double SEARCH_MPS = 0.7;
  private static final double APPROACH_MPS = 1.2; // to a gate's axis, and to the buoy at the end
  private static final double ALIGNED_RAD = Math.toRadians(50.0); // includes a crab angle

  private final List<Point> passed = new ArrayList<>();
  private Optional<Point> before = Optional.empty(); // place at the last state
  private Optional<Gate> last = Optional.empty();
  private boolean linedUp; // with the first gate

  ChannelState(PlannerView surroundings) {
    super(surroundings);
  }

  @Override
  public Class<? extends GoalInformation> goalClass() {
    return BuoyChannel.class;
  }

  @Override
  public void enter(Pursuit pursuit) {
    surroundings.begin();
    passed.clear();
    before = Optional.empty();
    last = Optional.empty();
    linedUp = false;
  }

  @Override
  public Plan plan(Pursuit pursuit) {
    BuoyChannel goal = (BuoyChannel) pursuit.goal();
    StateInformation state = pursuit.state();
    Point here = surroundings.here(state);
    List<Gate> gates =
        Gate.among(
            places(name(goal.left(), "buoy"), state), places(name(goal.right(), "buoy"), state));
    before.ifPresent(from -> pass(gates, from, here));
    before = Optional.of(here);
    BuoyChannel now = goal.copy().passed(passed.size());
    if (goal.gates().isPresent() && passed.size() >= goal.gates().getAsLong()) {
      return done(pursuit, now);
    }
    Optional<Gate> next = next(gates, here, last);
    Optional<Point> end = goal.endsAtBuoy() ? end(goal, state, here) : Optional.empty();
    if (end.isPresent() && !passed.isEmpty() && isBefore(end.get(), next, here)) {
      return away(end.get(), state) < AT_END_M
          ? done(pursuit, now)
          : step(pursuit, towards(pursuit, end.get(), AT_END_M, APPROACH_MPS), now);
    }
    if (next.isPresent()) {
      return through(next.get(), gates, here, pursuit, now);
    }
    return search(pursuit, here, now);
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

  private void pass(List<Gate> gates, Point from, Point here) {
    for (Gate gate : gates) {
      if (!isKnown(gate) && gate.isPassed(from, here)) {
        passed.add(gate.middle());
        last = Optional.of(gate);
        surroundings.begin();
      }
    }
  }

  private boolean isKnown(Gate gate) {
    Point middle = gate.middle();
    return passed.stream()
        .anyMatch(old -> Math.hypot(old.x() - middle.x(), old.y() - middle.y()) < SAME_M);
  }

  private Optional<Gate> next(List<Gate> gates, Point here, Optional<Gate> behind) {
    Gate nearest = null;
    double least = REACH_M;
    for (Gate gate : gates) {
      Point middle = gate.middle();
      double away = Math.hypot(middle.x() - here.x(), middle.y() - here.y());
      boolean isAhead =
          gate.aheadM(here) > -BEHIND_M
              && behind.map(old -> old.aheadM(middle) < -SAME_M).orElse(true);
      if (isAhead && !isKnown(gate) && away < least) {
        nearest = gate;
        least = away;
      }
    }
    return Optional.ofNullable(nearest);
  }

  private Optional<Point> end(BuoyChannel goal, StateInformation state, Point here) {
    return places(name(goal.endBuoy(), "buoy"), state).stream()
        .min((a, b) -> Double.compare(distance(a, here), distance(b, here)));
  }

  private static boolean isBefore(Point end, Optional<Gate> next, Point here) {
    return next.map(gate -> distance(end, here) < distance(gate.middle(), here)).orElse(true);
  }

  private static double distance(Point a, Point b) {
    return Math.hypot(a.x() - b.x(), a.y() - b.y());
  }

  private Plan through(Gate gate, List<Gate> gates, Point here, Pursuit pursuit, BuoyChannel now) {
    double ahead = gate.aheadM(here);
    Point from = last.map(Gate::middle).orElse(gate.beyond(-BEFORE_M));
    double aside = Math.abs(asideM(from, gate.middle(), here));
    linedUp |= last.isPresent() || isLinedUp(gate, here, pursuit.state());
    if (!linedUp || ahead > BEFORE_M / 2.0 && aside > OFF_M) {
      return approach(pursuit, here, gate.beyond(-BEFORE_M), now);
    }
    Point after =
        next(gates, gate.middle(), Optional.of(gate))
            .filter(other -> !other.equals(gate))
            .map(Gate::middle)
            .orElse(gate.beyond(BEFORE_M));
    Point aim = along(from, gate.middle(), after, here);
    Point farther = between(here, aim, FULL_SPEED_M / Math.max(0.1, distance(here, aim)));
    NavigationPoint point = surroundings.straight(pursuit.state(), farther);
    return Plan.underWay(List.of(point.speed(now.speed()))).changing(now);
  }

  /** Straight to a place if no object is near the way, otherwise around objects. */
  private Plan approach(Pursuit pursuit, Point here, Point place, BuoyChannel now) {
    StateInformation state = pursuit.state();
    double length = distance(here, place);
    boolean isClear =
        surroundings.objects().stream()
            .map(object -> surroundings.centre(object, state))
            .allMatch(object -> isClear(here, place, length, object));
    if (!isClear) {
      return step(pursuit, towards(pursuit, place, LINED_UP_M, APPROACH_MPS), now);
    }
    NavigationPoint point = surroundings.straight(state, place);
    return Plan.underWay(List.of(point.speed(APPROACH_MPS))).changing(now);
  }

  private static boolean isClear(Point here, Point place, double length, Point object) {
    double along =
        length > 0.0
            ? ((object.x() - here.x()) * (place.x() - here.x())
                    + (object.y() - here.y()) * (place.y() - here.y()))
                / length
            : 0.0;
    double within = Math.max(0.0, Math.min(length, along));
    Point nearest = length > 0.0 ? between(here, place, within / length) : here;
    return distance(nearest, object) > CLEAR_M;
  }

  private static boolean isLinedUp(Gate gate, Point here, StateInformation state) {
    Point way = gate.way();
    double off = state.psi().orElseThrow() - Math.atan2(way.y(), way.x());
    double ahead = gate.aheadM(here);
    return ahead > READY_M
        && ahead < BEFORE_M + 1.0
        && Math.abs(gate.asideM(here)) < LINED_UP_M
        && Math.abs(Math.IEEEremainder(off, 2.0 * Math.PI)) < ALIGNED_RAD;
  }

  /** Distance from the line between two places, positive to the right [m]. */
  private static double asideM(Point from, Point to, Point here) {
    double length = Math.max(1e-6, distance(from, to));
    double north = (to.x() - from.x()) / length;
    double east = (to.y() - from.y()) / length;
    return (here.y() - from.y()) * north - (here.x() - from.x()) * east;
  }

  /** Place ahead of the vehicle on the line through three places. */
  private static Point along(Point from, Point over, Point to, Point here) {
    double length = Math.max(1e-6, distance(from, over));
    double share =
        ((here.x() - from.x()) * (over.x() - from.x())
                + (here.y() - from.y()) * (over.y() - from.y()))
            / (length * length);
    double metres = share * length + AHEAD_M;
    return metres <= length
        ? between(from, over, metres / length)
        : between(over, to, (metres - length) / Math.max(1e-6, distance(over, to)));
  }

  private static Point between(Point from, Point to, double share) {
    return Point.of(
        from.x() + share * (to.x() - from.x()), from.y() + share * (to.y() - from.y()), 0.0);
  }

  /** To the entrance; from there, or from the last gate, straight on until a gate is seen. */
  private Plan search(Pursuit pursuit, Point here, BuoyChannel now) {
    if (last.isEmpty()) {
      Point entrance = station(now, pursuit.state());
      return step(pursuit, towards(pursuit, entrance, 1.0, now.speed()), now);
    }
    double beyond = -last.get().aheadM(here);
    if (beyond > BLIND_M) {
      return new Plan(List.of(), Plan.Progress.ABANDONED, "given up: no further gate was seen")
          .changing(now);
    }
    return step(
        pursuit, towards(pursuit, last.get().beyond(BLIND_M + AHEAD_M), 1.0, SEARCH_MPS), now);
  }

  private static Plan step(Pursuit pursuit, PlannerView.Step step, BuoyChannel now) {
    List<NavigationPoint> points = List.of(step.point());
    return step.givenUp()
        .map(reason -> new Plan(points, Plan.Progress.ABANDONED, "given up: " + reason))
        .orElseGet(() -> Plan.underWay(points))
        .changing(now);
  }

  private static Plan done(Pursuit pursuit, BuoyChannel now) {
    return new Plan(
            List.of(), Plan.Progress.COMPLETED, "reached, " + now.passed() + " gates passed")
        .changing(now);
  }
}
