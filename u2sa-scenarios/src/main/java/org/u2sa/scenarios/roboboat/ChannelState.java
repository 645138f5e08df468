package org.u2sa.scenarios.roboboat;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.planning.Plan;
import org.u2sa.planning.PlannerView;
import org.u2sa.planning.Pursuit;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.seen.PlanarShape;
import org.u2sa.scenarios.roboboat.gate.Gate;
import org.u2sa.scenarios.roboboat.gate.GateApproach;
import org.u2sa.scenarios.roboboat.gate.GateLine;
import org.u2sa.scenarios.roboboat.gate.GateSequence;
import org.u2sa.scenarios.roboboat.gate.SailingPath;

/**
 * Passes the gates of a {@link BuoyChannel} in order: always the nearest gate ahead that has not
 * been passed. Far from it, the boat goes around obstacles to a point in front of the gate;
 * otherwise it follows the line through the middles of the gates.
 */
final class ChannelState extends TaskState {
  private static final double BEFORE_M = 4.0; // beyond a gate without a known next one
  private static final double FULL_SPEED_M =
      8.0; // distance of a point at which control does not slow down
  private static final double AHEAD_M = 2.2; // look-ahead along the line
  private static final double FIRST_M = 8.0; // maximum distance from the entrance to the first gate
  private static final double AT_ENTRANCE_M = 3.0;
  private static final double LOOK_S = 30.0; // time to search for the first gate at the entrance
  private static final double BLIND_M =
      10.0; // distance straight on without a gate in sight, more than to the next gate
  private static final double AT_END_M = 8.0; // distance from the buoy at the end
  private static final double SEARCH_MPS = 0.7;
  private static final double APPROACH_MPS = 1.2; // speed to a gate's axis and the end buoy
  private static final double MOVED_M = 0.8; // shift of the start of the run that causes replanning
  private static final double OFF_M = 1.2; // deviation from the planned path that causes replanning
  private static final double RETRY_M = 0.5; // distance between two attempts to plan
  private static final double ARRIVED_M = 1.5; // distance from the point in front of the gate
  private static final int DIRECTIONS = 8; // number of directions tried there
  private static final double DECIDE_M = 3.0; // last point in front of a gate at which to break off
  private static final double STEEPEST = 0.25; // slope of the way back to the line
  private static final double TWICE_M = 2.5; // closer buoys of one colour are the same
  private static final double UNKNOWN_SIGMA_M = 10.0;
  private static final int MAX_BREAK_OFFS = 3;

  private final GateSequence gates = new GateSequence();
  private Optional<Point> lineFrom = Optional.empty(); // start of the line to the next gate
  private Optional<GateApproach> approach = Optional.empty(); // set while not on that line
  private Optional<Point> triedAt = Optional.empty(); // position at the last planning
  private OptionalDouble arrivedS = OptionalDouble.empty(); // arrival at the entrance
  private double turnsS; // time of the next plan starting with a turn
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
    gates.begin();
    lineFrom = Optional.empty();
    approach = Optional.empty();
    triedAt = Optional.empty();
    arrivedS = OptionalDouble.empty();
    turnsS = 0.0;
    breakOffs = 0;
  }

  @Override
  public Plan plan(Pursuit pursuit) {
    BuoyChannel goal = (BuoyChannel) pursuit.goal();
    StateInformation state = pursuit.state();
    Point here = surroundings.here(state);
    List<Gate> seen =
        Gate.among(
            places(name(goal.left(), "buoy"), state), places(name(goal.right(), "buoy"), state));
    if (gates.move(seen, here)) {
      lineFrom = gates.last().map(Gate::middle);
      approach = Optional.empty();
      surroundings.begin();
    }
    BuoyChannel now = goal.copy().passed(gates.passed());
    if (goal.gates().isPresent() && goal.gates().getAsLong() < 1) {
      return givenUp("gates: " + goal.gates().getAsLong() + ", expected 1 or more", now);
    }
    if (goal.gates().isPresent() && gates.passed() >= goal.gates().getAsLong()) {
      return done(pursuit, now);
    }
    Optional<Gate> next = target(here, goal, state);
    Optional<Point> end = goal.endsAtBuoy() ? end(goal, state, here) : Optional.empty();
    if (end.isPresent() && gates.passed() > 0 && isBefore(end.get(), next, here)) {
      return away(end.get(), state) < AT_END_M
          ? done(pursuit, now)
          : step(pursuit, towards(pursuit, end.get(), AT_END_M, APPROACH_MPS), now);
    }
    gates.aimAt(next);
    if (next.isPresent()) {
      return through(next.get(), pursuit, now);
    }
    return search(pursuit, here, now);
  }

  private List<Point> places(String type, StateInformation state) {
    return known(
        surroundings.objects().stream()
            .filter(object -> object.objectType().equals(type))
            .sorted(Comparator.comparingDouble(ChannelState::sigmaM))
            .map(object -> surroundings.centre(object, state)));
  }

  /**
   * Positions of the buoys of a colour. A buoy mapped twice, because distant sightings were
   * inaccurate, counts once, at its most certain position: gates are at least 4 m apart, so two
   * buoys of a colour are never that close.
   *
   * @param places most certain first
   */
  static List<Point> known(Stream<Point> places) {
    List<Point> known = new ArrayList<>();
    places
        .filter(place -> known.stream().allMatch(each -> each.flatDistanceTo(place) > TWICE_M))
        .forEachOrdered(known::add);
    return known;
  }

  /** Outlines of all objects except duplicates of buoys. */
  private List<PlanarShape> obstacles(Pursuit pursuit) {
    BuoyChannel goal = (BuoyChannel) pursuit.goal();
    StateInformation state = pursuit.state();
    List<String> types = List.of(name(goal.left(), "buoy"), name(goal.right(), "buoy"));
    List<Point> known = new ArrayList<>();
    types.forEach(type -> known.addAll(places(type, state)));
    List<ObjectDescription> objects = surroundings.objects();
    List<PlanarShape> outlines = surroundings.outlines(state); // in the same order
    List<PlanarShape> obstacles = new ArrayList<>();
    for (int i = 0; i < objects.size(); i++) {
      boolean isBuoy = types.contains(objects.get(i).objectType());
      if (!isBuoy || known.contains(surroundings.centre(objects.get(i), state))) {
        obstacles.add(outlines.get(i));
      }
    }
    return obstacles;
  }

  private static double sigmaM(ObjectDescription object) {
    return object.motion().sigma().map(Point::distance).orElse(UNKNOWN_SIGMA_M);
  }

  /** The gate to be passed next: while on the way to a gate, that gate. */
  private Optional<Gate> target(Point here, BuoyChannel goal, StateInformation state) {
    if (approach.isPresent()) {
      return gates.again(approach.get().gate());
    }
    return gates.last().isPresent()
        ? gates.next(here, gates.last().get())
        : gates.nearest(station(goal, state), FIRST_M);
  }

  private Optional<Point> end(BuoyChannel goal, StateInformation state, Point here) {
    return places(name(goal.endBuoy(), "buoy"), state).stream()
        .min(Comparator.comparingDouble(place -> place.flatDistanceTo(here)));
  }

  private static boolean isBefore(Point end, Optional<Gate> next, Point here) {
    return next.map(gate -> end.flatDistanceTo(here) < gate.middle().flatDistanceTo(here))
        .orElse(true);
  }

  private Plan through(Gate gate, Pursuit pursuit, BuoyChannel now) {
    Point here = surroundings.here(pursuit.state());
    if (lineFrom.isEmpty()) {
      return approach(gate, here, pursuit, now);
    }
    Point middle = gate.middle();
    Point after = gates.next(middle, gate).map(Gate::middle).orElse(gate.beyond(BEFORE_M));
    GateLine line = new GateLine(lineFrom.get(), middle, after);
    if (mustBreakOff(gate, line, here) && plan(gate, here, pursuit)) {
      breakOffs++;
      lineFrom = Optional.empty();
      return approach(gate, here, pursuit, now);
    }
    return steer(pursuit, here, line.ahead(here, AHEAD_M), now.speed(), now);
  }

  /** Whether the boat drifts too far from the axis of the first gate to pass it. */
  private boolean mustBreakOff(Gate gate, GateLine line, Point here) {
    double ahead = gate.aheadM(here);
    return gates.last().isEmpty()
        && breakOffs < MAX_BREAK_OFFS
        && ahead > DECIDE_M
        && ahead < DECIDE_M + 2.0
        && Math.abs(line.asideM(here)) > STEEPEST * ahead;
  }

  /** Follows planned arcs to the start of a straight run; without a plan, goes around objects. */
  private Plan approach(Gate gate, Point here, Pursuit pursuit, BuoyChannel now) {
    StateInformation state = pursuit.state();
    boolean isOff =
        approach
            .map(way -> way.movedM(gate) > MOVED_M || way.path().offM(here) > OFF_M)
            .orElse(true);
    if (isOff && triedAt.map(place -> place.flatDistanceTo(here) > RETRY_M).orElse(true)) {
      triedAt = Optional.of(here);
      plan(gate, here, pursuit);
    }
    if (approach.isEmpty()) {
      Point before = GateApproach.before(gate, obstacles(pursuit));
      if (away(before, state) > ARRIVED_M || !planTurning(gate, here, pursuit)) {
        return step(pursuit, towards(pursuit, before, 1.0, APPROACH_MPS), now);
      }
    }
    SailingPath path = approach.get().path();
    path.follow(here);
    if (path.leftM() < AHEAD_M / 2.0) {
      lineFrom = Optional.of(gate.beyond(-approach.get().runM()));
      approach = Optional.empty();
    }
    return steer(pursuit, here, path.ahead(AHEAD_M), APPROACH_MPS, now);
  }

  /** Plans once a second, starting in any direction, because there is room to turn in place. */
  private boolean planTurning(Gate gate, Point here, Pursuit pursuit) {
    if (pursuit.missionS() < turnsS) {
      return false;
    }
    turnsS = pursuit.missionS() + 1.0;
    List<PlanarShape> objects = obstacles(pursuit);
    for (int k = 0; k < DIRECTIONS && approach.isEmpty(); k++) {
      Pose pose = new Pose(here.x(), here.y(), 2.0 * Math.PI * k / DIRECTIONS);
      approach = GateApproach.plan(pose, gate, objects);
    }
    return approach.isPresent();
  }

  private boolean plan(Gate gate, Point here, Pursuit pursuit) {
    Pose pose = new Pose(here.x(), here.y(), surroundings.courseRad(pursuit.state()));
    Optional<GateApproach> planned = GateApproach.plan(pose, gate, obstacles(pursuit));
    approach = planned.or(() -> approach);
    return planned.isPresent();
  }

  private Plan steer(Pursuit pursuit, Point here, Point aim, double speedMps, BuoyChannel now) {
    Point farther =
        GateLine.between(here, aim, FULL_SPEED_M / Math.max(0.1, here.flatDistanceTo(aim)));
    NavigationPoint point = surroundings.straight(pursuit.state(), farther);
    return Plan.underWay(List.of(point.speed(speedMps))).changing(now);
  }

  /** Goes to the entrance, then, or from the last gate, straight on until a gate is in sight. */
  private Plan search(Pursuit pursuit, Point here, BuoyChannel now) {
    if (gates.last().isEmpty()) {
      Point entrance = station(now, pursuit.state());
      if (arrivedS.isEmpty() && away(entrance, pursuit.state()) < AT_ENTRANCE_M) {
        arrivedS = OptionalDouble.of(pursuit.missionS());
      }
      if (arrivedS.isPresent() && pursuit.missionS() - arrivedS.getAsDouble() > LOOK_S) {
        return givenUp("no gate at the entrance", now);
      }
      return step(pursuit, towards(pursuit, entrance, 1.0, now.speed()), now);
    }
    double beyond = -gates.last().get().aheadM(here);
    if (beyond > BLIND_M) {
      return givenUp("no further gate was seen", now);
    }
    return step(
        pursuit,
        towards(pursuit, gates.last().get().beyond(BLIND_M + AHEAD_M), 1.0, SEARCH_MPS),
        now);
  }

  private static Plan givenUp(String reason, BuoyChannel now) {
    return new Plan(List.of(), Plan.Progress.ABANDONED, "given up: " + reason).changing(now);
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
