package org.u2sa.planning.avoidance;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BiConsumer;
import java.util.function.Supplier;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.interfaces.terrain.HeightGrid;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.PathStatus;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.avoidance.GoalAttempt.TrafficHold;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.guidance.LineSettings;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.local.ArcChoice;
import org.u2sa.planning.local.ArcChooser;
import org.u2sa.planning.local.MotionLimits;
import org.u2sa.planning.local.RouteTrack;
import org.u2sa.planning.local.VerticalRoom;
import org.u2sa.planning.route.RoutePlanner;
import org.u2sa.planning.route.RoutePlanners;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.seen.PlanarShape;
import org.u2sa.planning.seen.PlanningPlane;
import org.u2sa.planning.seen.SeenWorld;

/**
 * Avoids the obstacles in the world model: a {@link RouteKeeper} plans the way to the goal, a
 * {@link GoalAttempt} decides what the vehicle does, and an {@link ArcChooser} chooses its next
 * motion. Confined to the planner's thread.
 */
public final class Avoidance {
  private static final String NONE = "NONE";

  /** Fraction of its speed below which a vehicle that cannot stop or hover has not taken off. */
  private static final double SHARE_FLYING = 0.5;

  /** Height above the place of landing below which obstacles are not looked for [m]. */
  private static final double LOWEST_M = 2.0;

  private final Supplier<String> chosen;
  private final Supplier<AvoidanceVariables> settings;
  private final Supplier<LineSettings> lines;
  private final BiConsumer<String, Boolean> say; // message, and whether it is a warning
  private final SeenWorld world;
  private final Passages passages;
  private final VirtualObstacles obstacles;
  private final RouteKeeper routes;
  private final PathNews news;
  private final VerticalEvasion climbing;
  private final DriftWatch drift;
  private PlanningPlane plane;
  private Optional<GoalAttempt> attempt = Optional.empty(); // from the first step to a goal
  private boolean makesRoom; // to turn in place
  private Optional<Held> held = Optional.empty();

  /** The last choice of a vehicle that cannot stop: it holds for a few metres of flight. */
  private record Held(ArcChoice choice, Wanted wanted, long micros) {
    private static final long LASTS_MICROS = 100_000;

    boolean isFor(Wanted now, long nowMicros) {
      return now.goal().equals(wanted.goal())
          && now.target().equals(wanted.target())
          && nowMicros - micros < LASTS_MICROS;
    }
  }

  /**
   * Next step of the vehicle.
   *
   * @param ned vector from the vehicle [m]
   * @param speedMps speed [m/s]
   * @param backwards whether in reverse
   * @param givenUp reason for giving up the goal, or empty
   */
  public record Step(Point ned, double speedMps, boolean backwards, Optional<String> givenUp) {
    /** The step as a navigation point. */
    public NavigationPoint point(Vehicle vehicle) {
      NavigationPoint point = NavigationPoint.at(vehicle.body(ned)).speed(speedMps);
      return backwards ? point.backwards(true) : point;
    }
  }

  public record Wanted(
      String goal,
      Place target,
      double thresholdM,
      OptionalDouble headingRad,
      OptionalDouble speedMps) {}

  /**
   * @param configuration configuration of the planner, in which PLANNER selects the route planner
   * @param say reports a message to the operator; true for a warning
   * @param terrain the ground, if it is known
   */
  public Avoidance(
      Configurator configuration,
      Supplier<AvoidanceVariables> settings,
      Supplier<LineSettings> lines,
      BiConsumer<String, Boolean> say,
      Optional<HeightGrid> terrain) {
    this.settings = settings;
    this.lines = lines;
    this.say = say;
    Map<String, RoutePlanner> planners = new LinkedHashMap<>(RoutePlanners.all(configuration));
    List<String> names = new ArrayList<>(planners.keySet());
    names.add(0, NONE);
    VariableDeclaration<String> planner =
        VariableDeclaration.text("PLANNER")
            .oneOf(names.toArray(new String[0]))
            .ifAbsent(NONE)
            .describedAs(
                "NONE ignores obstacles; GRID avoids them for vehicles that turn on the spot, "
                    + "HYBRID for vehicles with a minimum turn radius; other names are planners of "
                    + "extensions.");
    chosen = () -> configuration.getVariable(planner);
    chosen.get(); // an invalid value must fail before the vehicle moves
    passages = new Passages(settings, this::turnsOnTheSpot);
    world = new SeenWorld(passages::reading);
    obstacles = new VirtualObstacles(world);
    routes = new RouteKeeper(world, obstacles, passages, () -> planners.get(chosen.get()), say);
    news = new PathNews(settings, say);
    climbing = new VerticalEvasion(terrain, say);
    drift = new DriftWatch(settings);
  }

  /** Learns the drift of the vehicle, whatever it pursues. */
  public void see(Vehicle vehicle) {
    drift.see(vehicle);
  }

  public boolean isOn() {
    return !chosen.get().equals(NONE);
  }

  public SeenWorld world() {
    return world;
  }

  public boolean turnsOnTheSpot() {
    return turnRadiusM(0.0) == 0.0;
  }

  /** Remaining length of the route [m]; empty without one. */
  public OptionalDouble remainingM() {
    return routes.track().stream().mapToDouble(RouteTrack::remainingM).findAny();
  }

  /** Vector to a place ahead on the route: north, east, down [m]; empty without one. */
  public Optional<Point> ahead(Vehicle vehicle) {
    if (!isOn() || plane == null) {
      return Optional.empty();
    }
    Point at = vehicle.on(plane);
    double ahead = lines.get().lookAheadM(vehicle.speedMps());
    return routes
        .track()
        .map(way -> Point.of(way.northAheadM(ahead) - at.x(), way.eastAheadM(ahead) - at.y(), 0.0));
  }

  public void begin() {
    attempt = Optional.empty();
    held = Optional.empty();
    routes.begin();
    obstacles.forgetGaps();
    passages.widen();
    news.begin();
  }

  /**
   * Whether something is in the way of a vehicle that flies straight on to a place: an obstacle
   * near the line, or traffic.
   */
  public boolean isHindered(Vehicle vehicle, StateInformation state, Place to) {
    boolean hasTraffic = comesTraffic(vehicle, state, to);
    AvoidanceVariables now = settings.get();
    Point at = vehicle.on(plane);
    Point way = vehicle.nedOf(to);
    double keptM = body(now).circleM() + now.clearance();
    for (PlanarShape shape : world.shapes()) {
      double stepM = Math.max(1.0, 0.5 * keptM);
      int steps = (int) Math.ceil(Math.hypot(way.x(), way.y()) / stepM);
      for (int i = 0; i <= steps; i++) {
        double share = steps == 0 ? 0.0 : (double) i / steps;
        if (shape.distanceM(at.x() + share * way.x(), at.y() + share * way.y()) < keptM) {
          return true;
        }
      }
    }
    return hasTraffic;
  }

  /**
   * Whether a static obstacle, as of the last update, is too near to a straight descent to a place
   * on the ground. Near the ground as much distance is kept as the aircraft is high.
   */
  public boolean blocksDescent(Vehicle vehicle, StateInformation state, Place from, Place to) {
    AvoidanceVariables now = settings.get();
    Point at = vehicle.on(world.plane(state));
    Point end = vehicle.nedOf(to);
    Point way = end.minus(vehicle.nedOf(from));
    double circleM = body(now).circleM();
    double stepM = Math.max(1.0, 0.5 * circleM);
    List<PlanarShape> shapes = new ArrayList<>(world.shapes());
    shapes.addAll(world.shapesElsewhere());
    for (double share = 1.0; share * way.z() > LOWEST_M; share -= stepM / way.distance()) {
      double aboveM = share * way.z();
      double north = at.x() + end.x() - share * way.x();
      double east = at.y() + end.y() - share * way.y();
      double down = at.z() + end.z() - aboveM;
      for (PlanarShape shape : shapes) {
        boolean isAsHigh =
            now.verticalClearance() == 0.0
                || shape.reaches(down, down, Math.min(now.verticalClearance(), 0.5 * aboveM));
        double keptM = circleM + Math.min(now.clearance(), aboveM);
        if (isAsHigh && shape.distanceM(north, east) < keptM) {
          return true;
        }
      }
    }
    return false;
  }

  /**
   * Whether traffic comes near within the horizon if the vehicle flies straight on.
   *
   * @param to place to which it climbs or descends
   */
  public boolean comesTraffic(Vehicle vehicle, StateInformation state, Place to) {
    AvoidanceVariables now = settings.get();
    lieOn(world.plane(state));
    Point at = vehicle.on(plane);
    world.update(state, at.x(), at.y(), at.z(), at.z() + vehicle.nedOf(to).z());
    return TrafficHold.comesNear(
        world.movers(),
        vehicle,
        at,
        body(now).circleM() + 2.0 * now.trafficClearance(),
        now.trafficHorizon());
  }

  /** Called when a waypoint was reached: blocks the way back. */
  public void reached(Vehicle vehicle, StateInformation state) {
    AvoidanceVariables now = settings.get();
    if (now.closeBehind() > 0.0) {
      lieOn(world.plane(state));
      Point at = vehicle.on(plane);
      Pose pose = new Pose(at.x(), at.y(), vehicle.headingRad());
      obstacles.closeBehind(pose, body(now).circleM(), now.closeBehind());
    }
  }

  private void lieOn(PlanningPlane now) {
    if (now != plane) {
      plane = now;
      held = Optional.empty();
      obstacles.forgetAll();
    }
  }

  /** Returns path changes for displays once; empty if none. */
  public Optional<PlannedPath> news() {
    return news.take();
  }

  private BodyDiscs body(AvoidanceVariables now) {
    return now.body(turnsOnTheSpot());
  }

  private double turnRadiusM(double speedMps) {
    AvoidanceVariables now = settings.get();
    double speed = Math.max(speedMps, Math.max(now.plannedSpeed(), now.minSpeed()));
    return now.turnRadius() > 0.0 ? now.turnRadius() : lines.get().turns().radiusM(speed);
  }

  public Step step(Vehicle vehicle, StateInformation state, Wanted wanted) {
    AvoidanceVariables now = settings.get();
    long micros = vehicle.timestampMicros();
    lieOn(world.plane(state));
    Point at = vehicle.on(plane);
    Point toGoal = vehicle.nedOf(wanted.target());
    if (held.isPresent() && held.get().isFor(wanted, micros)) {
      return step(held.get().choice(), at, toGoal, wanted, Optional.empty());
    }
    GoalAttempt current = attempt.orElseGet(() -> new GoalAttempt(routes, passages, say, micros));
    attempt = Optional.of(current);
    world.overlook(current.overlooks(now, micros));
    // An aircraft moves along its course, not its heading.
    double ahead = now.stops() ? vehicle.headingRad() : vehicle.courseRad();
    Pose pose = new Pose(at.x(), at.y(), ahead);
    if (!now.passSides().isEmpty()) {
      obstacles.keepSides(pose, state, routes.track(), now);
    }
    world.update(state, at.x(), at.y(), at.z(), at.z() + toGoal.z());
    Situation situation =
        new Situation(
            pose,
            at.x() + toGoal.x(),
            at.y() + toGoal.y(),
            wanted.headingRad(),
            wanted.thresholdM(),
            limits(vehicle, wanted, now),
            world.costs().frame().cellM(),
            body(now),
            turnRadiusM(0.0),
            now,
            micros);
    routes.update(situation);
    Optional<VerticalRoom> room =
        climbing.room(state, at, toGoal, wanted.target(), now, world, plane);
    ArcChoice choice = current.choose(arcs(situation, vehicle, room), situation);
    climbing.chosen(choice, at, micros);
    makesRoom = choice.kind() == ArcChoice.Kind.MAKE_ROOM;
    Optional<String> givenUp = current.judge(choice, isTrafficNear(situation), situation);
    announce(status(choice, givenUp, current), givenUp, wanted, at);
    held = now.stops() ? Optional.empty() : Optional.of(new Held(choice, wanted, micros));
    return step(choice, at, toGoal, wanted, givenUp);
  }

  private Step step(
      ArcChoice choice, Point at, Point toGoal, Wanted wanted, Optional<String> givenUp) {
    AvoidanceVariables now = settings.get();
    return new Step(
        Point.of(
            choice.northM() - at.x(),
            choice.eastM() - at.y(),
            Double.isNaN(choice.toDownM()) ? toGoal.z() : choice.toDownM() - at.z()),
        now.stops() ? choice.speedMps() : wantedMps(wanted, now),
        choice.backwards(),
        givenUp);
  }

  /** Wanted speed of the vehicle; airspeed for aircraft [m/s]. */
  private static double wantedMps(Wanted wanted, AvoidanceVariables now) {
    return Math.max(now.minSpeed(), wanted.speedMps().orElse(now.plannedSpeed()));
  }

  private MotionLimits limits(Vehicle vehicle, Wanted wanted, AvoidanceVariables now) {
    double wantedMps = wantedMps(wanted, now);
    // Wind adds to an aircraft's speed: plan with its ground speed.
    boolean drifts = !now.stops() && vehicle.speedMps() > SHARE_FLYING * wantedMps;
    return new MotionLimits(
        drifts ? vehicle.speedMps() : wantedMps,
        now.plannedAcceleration(),
        now.plannedBraking(),
        turnRadiusM(vehicle.speedMps()),
        now.stops(),
        now.reverses(),
        lines.get().lookAheadM(vehicle.speedMps()),
        now.touchM(world.costs().frame().cellM()),
        now.preferredClearance(),
        now.trafficClearance(),
        now.trafficHorizon(),
        now.reactionTime(),
        Math.toRadians(now.plannedTurnRate()));
  }

  private ArcChooser arcs(Situation now, Vehicle vehicle, Optional<VerticalRoom> room) {
    double heading = now.pose().headingRad();
    double along = vehicle.northMps() * Math.cos(heading) + vehicle.eastMps() * Math.sin(heading);
    return new ArcChooser(
        world.costs(),
        now.body(),
        room.isPresent() ? world.allMovers() : world.movers(),
        now.limits(),
        now.pose(),
        along,
        now.micros(),
        makesRoom,
        room,
        drift.drift());
  }

  private boolean isTrafficNear(Situation now) {
    MotionLimits limits = now.limits();
    double kept = now.body().circleM() + limits.trafficM() + limits.lookAheadM();
    return TrafficHold.isNear(world.movers(), now.pose(), kept, limits.horizonS(), now.micros());
  }

  private PathStatus status(ArcChoice choice, Optional<String> givenUp, GoalAttempt current) {
    if (givenUp.isPresent()) {
      return PathStatus.GIVEN_UP;
    }
    if (choice.kind() == ArcChoice.Kind.BRAKE) {
      return PathStatus.BRAKING;
    }
    boolean isFreeing = routes.track().isEmpty() && routes.obstacle().isEmpty();
    if (isFreeing && current.hasRecovered()) {
      return PathStatus.RECOVERING;
    }
    return choice.kind() == ArcChoice.Kind.WAIT ? PathStatus.WAITING : PathStatus.FOLLOWED;
  }

  private void announce(PathStatus status, Optional<String> givenUp, Wanted wanted, Point at) {
    news.announce(
        () -> new PlannedPath().goal(wanted.goal()).planner(chosen.get()),
        status,
        givenUp.orElse(routes.obstacle()),
        routes.track(),
        plane,
        at.z());
  }
}
