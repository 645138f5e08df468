package org.u2sa.scenarios.roboboat;

import java.util.ArrayList;
import java.util.Comparator;
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
import org.u2sa.planning.curve.Pose;

/**
 * Passes the gates of a {@link BuoyChannel} in order: always the nearest one ahead that has not
 * been passed. Far from it, it goes around obstacles to a place before the gate; otherwise it
 * follows the line through the middles of the gates.
 */
final class ChannelState extends TaskState {
  private static final double BEFORE_M = 4.0; // beyond a gate without a known next one
  private static final double FAR_M = 10.0; // before a gate, while no way to it is clear
  private static final double FULL_SPEED_M =
      8.0; // distance of a point at which control does not slow down
  private static final double AHEAD_M = 2.2; // of the point on the line to steer to
  private static final double SAME_M = 2.0; // a gate this near one that was passed is the same
  private static final double KEPT_M = 4.0; // a gate this near is kept if a buoy is lost from sight
  private static final double BEHIND_M = 1.0; // a gate is still ahead
  private static final double REACH_M = 30.0; // to the next gate
  private static final double FIRST_M = 8.0; // from the entrance to the first gate
  private static final double BLIND_M = 25.0; // straight on without a gate in sight
  private static final double AT_END_M = 5.0; // from the buoy at the end
  private static final double SEARCH_MPS = 0.7;
  private static final double APPROACH_MPS = 1.2; // to a gate's axis, and to the buoy at the end
  private static final double MOVED_M = 0.8; // of the start of the run: the way is planned again
  private static final double OFF_M = 2.0; // from the planned way: it is planned again
  private static final double RETRY_M = 0.5; // between two attempts to plan
  private static final double DECIDE_M = 3.0; // before a gate: the last place to break off
  private static final double STEEPEST = 0.25; // of the way back to the line, aside per metre
  private static final int MOST_BREAK_OFFS = 3;

  private final List<Point> passed = new ArrayList<>();
  private Optional<Point> before = Optional.empty(); // place at the last state
  private Optional<Gate> last = Optional.empty();
  private Optional<Gate> aimed = Optional.empty(); // gate to be passed, at the last state
  private Optional<Point> lineFrom = Optional.empty(); // start of the line to the next gate
  private Optional<GateApproach> approach = Optional.empty(); // while not on that line
  private Optional<Point> triedAt = Optional.empty(); // place of the last planning
  private int breakOffs;

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
    aimed = Optional.empty();
    lineFrom = Optional.empty();
    approach = Optional.empty();
    triedAt = Optional.empty();
    breakOffs = 0;
  }

  @Override
  public Plan plan(Pursuit pursuit) {
    BuoyChannel goal = (BuoyChannel) pursuit.goal();
    StateInformation state = pursuit.state();
    Point here = surroundings.here(state);
    List<Gate> gates =
        Gate.among(
            places(name(goal.left(), "buoy"), state), places(name(goal.right(), "buoy"), state));
    aimed
        .filter(gate -> distance(gate.middle(), here) < KEPT_M)
        .filter(gate -> nearest(gates, gate.middle(), SAME_M).isEmpty())
        .ifPresent(gates::add);
    before.ifPresent(from -> pass(gates, from, here));
    before = Optional.of(here);
    BuoyChannel now = goal.copy().passed(passed.size());
    if (goal.gates().isPresent() && passed.size() >= goal.gates().getAsLong()) {
      return done(pursuit, now);
    }
    Optional<Gate> next = target(gates, here, goal, state);
    Optional<Point> end = goal.endsAtBuoy() ? end(goal, state, here) : Optional.empty();
    if (end.isPresent() && !passed.isEmpty() && isBefore(end.get(), next, here)) {
      return away(end.get(), state) < AT_END_M
          ? done(pursuit, now)
          : step(pursuit, towards(pursuit, end.get(), AT_END_M, APPROACH_MPS), now);
    }
    aimed = next;
    if (next.isPresent()) {
      return through(next.get(), gates, pursuit, now);
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
        lineFrom = Optional.of(gate.middle());
        approach = Optional.empty();
        surroundings.begin();
      }
    }
  }

  private boolean isKnown(Gate gate) {
    Point middle = gate.middle();
    return passed.stream()
        .anyMatch(old -> Math.hypot(old.x() - middle.x(), old.y() - middle.y()) < SAME_M);
  }

  /** The gate to be passed next: on a way to one, that one. */
  private Optional<Gate> target(
      List<Gate> gates, Point here, BuoyChannel goal, StateInformation state) {
    if (approach.isPresent()) {
      return nearest(gates, approach.get().gate().middle(), SAME_M);
    }
    return last.isPresent()
        ? next(gates, here, last)
        : nearest(gates, station(goal, state), FIRST_M);
  }

  private Optional<Gate> nearest(List<Gate> gates, Point place, double withinM) {
    return gates.stream()
        .filter(gate -> !isKnown(gate) && distance(gate.middle(), place) < withinM)
        .min(Comparator.comparingDouble(gate -> distance(gate.middle(), place)));
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
        .min(Comparator.comparingDouble(place -> distance(place, here)));
  }

  private static boolean isBefore(Point end, Optional<Gate> next, Point here) {
    return next.map(gate -> distance(end, here) < distance(gate.middle(), here)).orElse(true);
  }

  private static double distance(Point a, Point b) {
    return Math.hypot(a.x() - b.x(), a.y() - b.y());
  }

  private Plan through(Gate gate, List<Gate> gates, Pursuit pursuit, BuoyChannel now) {
    Point here = surroundings.here(pursuit.state());
    if (lineFrom.isEmpty()) {
      return approach(gate, here, pursuit, now);
    }
    Point from = lineFrom.get();
    if (mustBreakOff(gate, from, here) && plan(gate, here, pursuit.state())) {
      breakOffs++;
      lineFrom = Optional.empty();
      return approach(gate, here, pursuit, now);
    }
    Point after =
        next(gates, gate.middle(), Optional.of(gate))
            .filter(other -> !other.equals(gate))
            .map(Gate::middle)
            .orElse(gate.beyond(BEFORE_M));
    return steer(pursuit, here, along(from, gate.middle(), after, here), now.speed(), now);
  }

  /** Whether the boat comes too far from the axis of the first gate to pass it. */
  private boolean mustBreakOff(Gate gate, Point from, Point here) {
    double ahead = gate.aheadM(here);
    return last.isEmpty()
        && breakOffs < MOST_BREAK_OFFS
        && ahead > DECIDE_M
        && ahead < DECIDE_M + 2.0
        && Math.abs(asideM(from, gate.middle(), here)) > STEEPEST * ahead;
  }

  /** Along planned arcs to the start of a straight run; while there are none, around objects. */
  private Plan approach(Gate gate, Point here, Pursuit pursuit, BuoyChannel now) {
    StateInformation state = pursuit.state();
    boolean isOff =
        approach
            .map(
                way ->
way.movedM(gate) > MOVED_M || way.path().offM(here) > OFF_M)
            .orElse(true);
    if (isOff && triedAt.map(place -> distance(place, here) > RETRY_M).orElse(true)) {
      triedAt = Optional.of(here);
      plan(gate, here, state);
    }
    if (approach.isEmpty()) {
      return step(pursuit, towards(pursuit, gate.beyond(-FAR_M), 1.0, APPROACH_MPS), now);
    }
    SailingPath path = approach.get().path();
    path.follow(here);
    if (path.leftM() < AHEAD_M / 2.0) {
      lineFrom = Optional.of(gate.beyond(-approach.get().runM()));
      approach = Optional.empty();
    }
    return steer(pursuit, here, path.ahead(AHEAD_M), APPROACH_MPS, now);
  }

  private boolean plan(Gate gate, Point here, StateInformation state) {
    Pose pose = new Pose(here.x(), here.y(), surroundings.courseRad(state));
    Optional<GateApproach> planned =
        GateApproach.plan(pose, gate, surroundings.outlines(state));
    approach = planned.or(() -> approach);
    return planned.isPresent();
  }

  private Plan steer(Pursuit pursuit, Point here, Point aim, double speedMps, BuoyChannel now) {
    Point farther = between(here, aim, FULL_SPEED_M / Math.max(0.1, distance(here, aim)));
    NavigationPoint point = surroundings.straight(pursuit.state(), farther);
    return Plan.underWay(List.of(point.speed(speedMps))).changing(now);
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
