package org.u2sa.planning.avoidance;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BiConsumer;
import java.util.function.DoubleSupplier;
import java.util.function.Supplier;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.interfaces.terrain.HeightGrid;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.PathStatus;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.safety.FenceState;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.goals.PursuitTime;
import org.u2sa.planning.guidance.LineSettings;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.local.ArcChoice;
import org.u2sa.planning.local.ArcChooser;
import org.u2sa.planning.local.RouteTrack;
import org.u2sa.planning.local.VerticalRoom;
import org.u2sa.planning.route.RoutePlanner;
import org.u2sa.planning.route.RoutePlanners;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.seen.GroundMap;
import org.u2sa.planning.seen.Mover;
import org.u2sa.planning.seen.PlanningPlane;
import org.u2sa.planning.seen.SeenWorld;

/**
 * Avoids the obstacles in the world model: a {@link RouteKeeper} plans the way to the goal, a
 * {@link GoalAttempt} decides what the vehicle does, and an {@link ArcChooser} chooses its next
 * motion. Confined to the planner's thread.
 */
public final class Avoidance {
  private static final String NONE = "NONE";
  private static final double NEAR_M = 60.0; // goals at which an aircraft will soon stop
  private static final double IN_PLACE_M = 2.0; // beside or above, within which it is at a place
  private static final long LONGEST_STEP_MICROS = Clock.MICROS_PER_SECOND;

  private final Supplier<String> chosen;
  private final Supplier<AvoidanceVariables> settings;
  private final Supplier<LineSettings> lines;
  private final PursuitTime time;
  private final BiConsumer<String, Boolean> say; // receives a message, and whether it is a warning
  private final SeenWorld world;
  private final Passages passages;
  private final VirtualObstacles obstacles;
  private final RouteKeeper routes;
  private final PathNews news;
  private final VerticalEvasion climbing;
  private final RouteGround highGround;
  private final CruiseAltitude cruise;
  private final StraightWays straight;
  private final VerticalGuard vertical;
  private final InPlaceEvasion inPlace;
  private final DriftWatch drift;
  private final HoverEvasion hover;
  private final TurnInsideFence turn;
  private PlanningPlane plane;
  private Optional<GoalAttempt> attempt = Optional.empty(); // set at the first step
  private Optional<ArcChoice> before = Optional.empty(); // last choice, on the plane
  private Optional<HeldChoice> held = Optional.empty();
  private long steppedMicros = Long.MIN_VALUE; // state of the last step
  private Optional<Place> began = Optional.empty(); // where the first step was made
  private Optional<Place> covered = Optional.empty(); // where something came above or below it
  private String blocker = ""; // stands on the way back to where the vehicle hovers

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
      OptionalDouble speedMps) {
    private Wanted at(Place altitude) {
      return with(target.orAltitudeOf(altitude));
    }

    /** The same at another position. */
    Wanted with(Place other) {
      return new Wanted(goal, other, thresholdM, headingRad, speedMps);
    }
  }

  /**
   * @param configuration configuration of the planner, in which PLANNER selects the route planner
   * @param time time against which patience with a goal is measured
   * @param say reports a message to the operator; true for a warning
   * @param terrain the ground, if it is known
   * @param slope slope of climbs and descents of aircraft without EVASION CLIMB
   */
  public Avoidance(
      Configurator configuration,
      Supplier<AvoidanceVariables> settings,
      Supplier<LineSettings> lines,
      PursuitTime time,
      BiConsumer<String, Boolean> say,
      Optional<HeightGrid> terrain,
      DoubleSupplier slope) {
    this.settings = settings;
    this.lines = lines;
    this.time = time;
    this.say = say;
    Map<String, RoutePlanner> planners = new LinkedHashMap<>(RoutePlanners.all(configuration));
    List<String> names = new ArrayList<>(planners.keySet());
    names.add(0, NONE);
    VariableDeclaration<String> planner =
        VariableDeclaration.text("PLANNER")
            .oneOf(names.toArray(new String[0]))
            .ifAbsent(NONE)
            .describedAs(
                "NONE ignores obstacles; GRID avoids them for vehicles that turn in place, "
                    + "HYBRID for vehicles with a minimum turn radius; other names are planners of "
                    + "extensions.");
    chosen = () -> configuration.getVariable(planner);
    chosen.get(); // an invalid value must fail before the vehicle moves
    passages =
        new Passages(
            settings,
            this::turnsOnTheSpot,
            () -> isOn() && planners.get(chosen.get()).checksShape());
    world = new SeenWorld(passages::reading);
    obstacles = new VirtualObstacles(world);
    routes = new RouteKeeper(world, obstacles, passages, () -> planners.get(chosen.get()), say);
    news = new PathNews(settings, say);
    GroundMap map = new GroundMap(terrain);
    climbing = new VerticalEvasion(map, say);
    highGround = new RouteGround(map, world, slope);
    straight =
        new StraightWays(settings, lines, world, highGround, this::planeOf, this::remainingM);
    vertical = new VerticalGuard(world, time, say);
    cruise = new CruiseAltitude(map, world, climbing, vertical);
    drift = new DriftWatch(settings);
    inPlace = new InPlaceEvasion(world, climbing, settings, lines, say, this::arcs);
    hover = new HoverEvasion(world, climbing, settings, lines, say);
    turn = new TurnInsideFence(world, say);
  }

  /** Estimates the drift of the vehicle and records where it is, whatever its goal. */
  public void see(Vehicle vehicle, StateInformation state) {
    drift.see(vehicle);
    if (isOn() && settings.get().reverses()) {
      lieOn(world.plane(state));
      world.pass(body(settings.get()), vehicle.on(plane), vehicle.headingRad());
    }
  }

  public boolean isOn() {
    return !chosen.get().equals(NONE);
  }

  /** Whether and how fast the vehicle can move straight. */
  public StraightWays straight() {
    return straight;
  }

  public SeenWorld world() {
    return world;
  }

  /** Receives the fence in force: evasions in place, or from it, and turns home keep inside. */
  public void see(FenceState fence) {
    climbing.see(fence);
    inPlace.see(fence);
    hover.see(fence);
    turn.see(fence);
  }

  /**
   * Changes the point to which a returning vehicle moves if it can stop, but not turn in place, and
   * would turn over a limit of the fence in force.
   *
   * @param goal where it returns to; empty if it does not return
   */
  public void turnInsideFence(
      Vehicle vehicle, StateInformation state, NavigationPoint point, Optional<Place> goal) {
    AvoidanceVariables now = settings.get();
    double radiusM = now.turnRadius();
    if (goal.isEmpty() || !now.stops() || radiusM == 0.0 || guards(state)) {
      turn.leave();
      return;
    }
    lieOn(world.plane(state));
    Point toGoal = vehicle.nedOf(goal.get());
    turn.lead(
        point, vehicle, state, vehicle.on(plane), toGoal, radiusM, routes.track(), isOn(), now);
  }

  /** Whether the vehicle can stop. */
  public boolean stops() {
    return settings.get().stops();
  }

  /** Maximum speed in reverse [m/s]; 0 if the vehicle cannot reverse. */
  public double backwardsMps() {
    return settings.get().backwardsMps();
  }

  /** Whether the surroundings are unknown, or the newest data of them too old. */
  public boolean isBlind(Vehicle vehicle) {
    return isOn()
        && world
            .age()
            .trouble(vehicle.timestampMicros(), settings.get().worldStaleMicros())
            .isPresent();
  }

  public boolean turnsOnTheSpot() {
    return Situation.turnRadiusM(settings.get(), lines.get(), 0.0) == 0.0;
  }

  /** Turning radius for which routes are planned [m]; 0 for a vehicle that turns in place. */
  public double turnRadiusM(Vehicle vehicle) {
    return Situation.turnRadiusM(settings.get(), lines.get(), vehicle.speedMps());
  }

  /** Remaining length of the route [m]; empty without one. */
  public OptionalDouble remainingM() {
    return routes.track().stream().mapToDouble(RouteTrack::remainingM).findAny();
  }

  /** Vector to a point ahead on the route: north, east, down [m]; empty without one. */
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
    began = Optional.empty();
    covered = Optional.empty();
    held = Optional.empty();
    routes.begin();
    highGround.begin();
    cruise.begin();
    obstacles.forgetGaps();
    passages.widen();
    news.begin();
  }

  /**
   * Changes the point to which an aircraft that can stop flies straight, or at which it hovers, if
   * traffic comes too close there or on the way, unless a step has led there. A climb or descent in
   * place is left to {@link #guard}.
   *
   * @param end where it will stay; empty if the point only leads on
   * @return whether it evades traffic
   */
  public boolean evade(
      Vehicle vehicle, StateInformation state, NavigationPoint point, Optional<Place> end) {
    Point way = end.map(vehicle::nedOf).orElseGet(() -> vehicle.ned(point.point()));
    return evade(vehicle, state, point, way, end.isPresent());
  }

  private boolean evade(
      Vehicle vehicle,
      StateInformation state,
      NavigationPoint point,
      Point way,
      boolean staysThere) {
    long micros = vehicle.timestampMicros();
    if (!guards(state)
        || steppedMicros == micros
        || world.age().trouble(micros, settings.get().worldStaleMicros()).isPresent()) {
      return false;
    }
    lieOn(world.plane(state));
    Point at = vehicle.on(plane);
    boolean isLevel = Math.abs(way.z()) < IN_PLACE_M;
    if (!staysThere && !isLevel && Math.hypot(way.x(), way.y()) < IN_PLACE_M) {
      return false;
    }
    highGround.leave();
    world.update(state, at.x(), at.y(), at.z(), at.z() + way.z());
    Optional<ArcChoice> choice = hover.choose(vehicle, state, way);
    if (staysThere || choice.isPresent()) {
      steppedMicros = micros;
    }
    if (choice.isPresent()) {
      before = choice;
      Wanted here =
          new Wanted("", vehicle.place(), 0.0, OptionalDouble.empty(), OptionalDouble.empty());
      Step step = step(choice.get(), vehicle, at, way, here, Optional.empty());
      point.point(vehicle.body(step.ned())).speed(step.speedMps()).backwards(step.backwards());
    }
    return choice.isPresent();
  }

  /**
   * As {@link #evade}, for an aircraft that hovers without a goal: on its way back to its place it
   * also waits before what stands there, such as traffic that has stopped.
   */
  public boolean hover(Vehicle vehicle, StateInformation state, NavigationPoint point) {
    Point way = vehicle.ned(point.point());
    boolean evades = evade(vehicle, state, point, way, true);
    if (evades || !guards(state) || Math.hypot(way.x(), way.y()) < IN_PLACE_M) {
      return evades;
    }
    String stands = straight.blocker(vehicle, state, way).orElse("");
    if (!stands.isEmpty()) {
      point.point(Point.ORIGIN).speed(0.0);
    }
    if (!stands.isEmpty() && !stands.equals(blocker)) {
      say.accept("\"" + stands + "\" stands on the way to where it hovers: waiting", true);
    }
    blocker = stands;
    return false;
  }

  /** Whether it looks at what is above and below a vehicle that can stop. */
  public boolean guards(StateInformation state) {
    AvoidanceVariables now = settings.get();
    return isOn() && now.stops() && now.verticalClearance() > 0.0 && state.z().isPresent();
  }

  /**
   * Shortens the climb or descent to the next point of a vehicle that can stop: to the clearance of
   * obstacles above or below and, unless a step has led there, so that it keeps away from traffic,
   * if necessary to the side.
   *
   * @param goal UID of the goal
   * @param ground ground known below the vehicle
   * @return reason for giving up the goal, or empty
   */
  public Optional<String> guard(
      String goal,
      Vehicle vehicle,
      StateInformation state,
      NavigationPoint point,
      KnownGround ground) {
    AvoidanceVariables now = settings.get();
    if (!guards(state)) {
      return Optional.empty();
    }
    lieOn(world.plane(state));
    Point at = vehicle.on(plane);
    Point way = vehicle.ned(point.point());
    Point apart = way;
    double downM = way.z();
    if (VerticalGuard.matters(way)) {
      if (steppedMicros != vehicle.timestampMicros()) {
        highGround.leave();
        world.update(state, at.x(), at.y(), at.z(), at.z() + way.z());
        apart = inPlace.way(goal, vehicle, state, way, ground);
      }
      downM = vertical.untilObstacle(vehicle, at, apart, ground.landing(), body(now), now);
      point.point(vehicle.body(Point.of(apart.x(), apart.y(), downM)));
    }
    boolean byObstacle = downM != apart.z();
    return vertical.heldUp(goal, vehicle, way, downM != way.z(), byObstacle, now);
  }

  /** Whether the fence in force leaves room to climb to a place. */
  public boolean isInsideFence(Vehicle vehicle, StateInformation state, Place place) {
    double wayM = vehicle.nedOf(place).z();
    PlanningPlane on = planeOf(state);
    return climbing.inside(on, vehicle.on(on).z(), 0.0, wayM) == wayM;
  }

  /** Whether obstacles or traffic above or below held the vehicle up at the last state. */
  public boolean isHeldUp() {
    return vertical.isHeldUp();
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

  private Place altitude(Vehicle vehicle) {
    if (began.isEmpty()) {
      began = Optional.of(vehicle.place());
    }
    return began.get();
  }

  private PlanningPlane planeOf(StateInformation state) {
    lieOn(world.plane(state));
    return plane;
  }

  private void lieOn(PlanningPlane now) {
    if (now != plane) {
      plane = now;
      held = Optional.empty();
      before = Optional.empty();
      obstacles.forgetAll();
      highGround.begin();
      cruise.begin();
    }
  }

  /** Returns path changes for displays once; empty if none. */
  public Optional<PlannedPath> news() {
    return news.take();
  }

  private BodyDiscs body(AvoidanceVariables now) {
    return now.body(turnsOnTheSpot());
  }

  /**
   * The next step to a goal; to one without altitude, at that at which it began or, where the
   * ground requires it, higher.
   */
  public Step step(Vehicle vehicle, StateInformation state, Wanted goal) {
    AvoidanceVariables now = settings.get();
    long micros = vehicle.timestampMicros();
    lieOn(world.plane(state));
    Point at = vehicle.on(plane);
    Wanted wanted = now.verticalClearance() > 0.0 ? goal.at(altitude(vehicle)) : goal;
    wanted = cruise.over(wanted, goal, vehicle, plane, at, now);
    if (cruise.riseM(at) < 0.0) {
      double riseM = climbing.inside(plane, at.z(), vehicle.downMps(), cruise.riseM(at));
      double mps = Situation.wantedMps(wanted, now);
      return new Step(Point.of(0.0, 0.0, riseM), mps, false, Optional.empty());
    }
    wanted = uncovered(wanted, vehicle, state, at);
    Point toGoal = vehicle.nedOf(wanted.target());
    if (held.isPresent() && held.get().isFor(goal, micros)) {
      return step(held.get().choice(), vehicle, at, toGoal, wanted, Optional.empty());
    }
    GoalAttempt current =
        attempt.orElseGet(() -> new GoalAttempt(routes, passages, say, micros, time.micros()));
    attempt = Optional.of(current);
    world.overlook(current.overlooks(now, micros));
    // An aircraft moves along its course, not its heading.
    double ahead = now.stops() ? vehicle.headingRad() : vehicle.courseRad();
    Pose pose = new Pose(at.x(), at.y(), ahead);
    if (climbsOverGround(toGoal)) {
      current.leaveOut(Math.max(0L, Math.min(LONGEST_STEP_MICROS, micros - steppedMicros)));
    }
    steppedMicros = micros;
    if (!now.passSides().isEmpty()) {
      obstacles.keepSides(pose, state, routes.track(), now);
    }
    boolean hasAltitudes = state.z().isPresent() && wanted.target().upM().isPresent();
    double speedMps = Math.max(vehicle.speedMps(), Situation.wantedMps(wanted, now));
    Optional<String> inGround = highGround.see(plane, at, toGoal, hasAltitudes, speedMps, now);
    world.update(state, at.x(), at.y(), at.z(), at.z() + toGoal.z());
    world.leadTo(at.x() + toGoal.x(), at.y() + toGoal.y());
    Situation situation =
        Situation.of(
            pose, toGoal, wanted, vehicle, world.costs().frame().cellM(), now, lines.get());
    routes.climbsIf(() -> cruise.clears(vehicle, plane, at, toGoal, now));
    routes.update(situation);
    if (routes.isHopeless()
        && world.hasHighGround()
        && cruise.raise(vehicle, plane, at, toGoal, now)) {
      say.accept("the ground leaves no way to the goal: climbing", false);
    }
    Optional<VerticalRoom> room =
        climbing
            .room(state, at, toGoal, wanted.target(), now, world, plane, Optional.empty())
            .map(each -> now.stops() ? each.descendingTo(highGround::lowestM) : each);
    List<Mover> traffic = room.isPresent() ? world.allMovers() : world.movers();
    ArcChoice onRoute = current.choose(arcs(situation, vehicle, traffic, room), situation);
    Optional<ArcChoice> aside =
        leavesRoute(onRoute, toGoal, state, micros)
            ? hover.choose(vehicle, state, toGoal)
            : Optional.<ArcChoice>empty();
    ArcChoice choice = aside.orElse(onRoute);
    if (aside.isEmpty()) {
      climbing.chosen(choice, at, micros);
    }
    before = Optional.of(choice);
    Optional<String> givenUp =
        inGround.or(
            () -> current.judge(choice, isNear(traffic, situation), situation, time.micros()));
    PathStatus status = PathNews.status(choice, givenUp, current.hasRecovered(), routes);
    announce(status, givenUp, wanted, at);
    held = now.stops() ? Optional.empty() : Optional.of(new HeldChoice(choice, goal, micros));
    return step(choice, vehicle, at, toGoal, wanted, givenUp);
  }

  /** The goal, or at the vehicle's own altitude while something is above or below the vehicle. */
  private Wanted uncovered(Wanted wanted, Vehicle vehicle, StateInformation state, Point at) {
    if (!isCovered(vehicle, state, at, vehicle.nedOf(wanted.target()))) {
      covered = Optional.empty();
      return wanted;
    }
    covered = covered.or(() -> Optional.of(vehicle.place()));
    return wanted.with(wanted.target().at(covered.get().upM().orElseThrow()));
  }

  /**
   * Whether something above or below a vehicle that can stop is in the way of its climb or descent
   * to the altitude of a goal elsewhere, so that it first has to leave at its own altitude.
   */
  private boolean isCovered(Vehicle vehicle, StateInformation state, Point at, Point toGoal) {
    AvoidanceVariables now = settings.get();
    if (!guards(state)
        || world.costs() == null
        || vehicle.place().upM().isEmpty()
        || !VerticalGuard.matters(toGoal)
        || Math.hypot(toGoal.x(), toGoal.y()) < IN_PLACE_M) {
      return false;
    }
    Point way = Point.of(0.0, 0.0, toGoal.z());
    double freeM = vertical.untilObstacle(vehicle, at, way, Optional.empty(), body(now), now);
    return Math.abs(freeM) < Math.abs(toGoal.z());
  }

  /** Whether an aircraft climbs because the ground leaves no way at its altitude yet. */
  private boolean climbsOverGround(Point toGoal) {
    return cruise.hasClimbed()
        && routes.track().isEmpty()
        && world.hasHighGround()
        && toGoal.z() < -IN_PLACE_M;
  }

  /**
   * Whether an aircraft that can stop evades as where it hovers: if it cannot follow its route to a
   * near goal because of traffic, past which each arc would lead; and wherever all its arcs lead
   * into the separation of traffic, in the middle of which it must not stop.
   */
  private boolean leavesRoute(
      ArcChoice onRoute, Point toGoal, StateInformation state, long micros) {
    boolean isNear = Math.hypot(toGoal.x(), toGoal.y()) < NEAR_M;
    boolean isInvaded = onRoute.kind() == ArcChoice.Kind.BRAKE;
    boolean begins = isInvaded || isNear && onRoute.kind() != ArcChoice.Kind.FOLLOW;
    return guards(state) && (begins || hover.isUnderWay(micros));
  }

  private Step step(
      ArcChoice choice,
      Vehicle vehicle,
      Point at,
      Point toGoal,
      Wanted wanted,
      Optional<String> givenUp) {
    AvoidanceVariables now = settings.get();
    // without a route, it does not descend to what may be between it and the goal
    boolean staysHigh = highGround.counts() && routes.track().isEmpty();
    double wayM = staysHigh ? Math.min(0.0, toGoal.z()) : toGoal.z();
    double levelM = now.stops() ? highGround.above(at, vehicle, wayM, now) : wayM;
    double downM = Double.isNaN(choice.toDownM()) ? levelM : choice.toDownM() - at.z();
    return new Step(
        Point.of(
            choice.northM() - at.x(),
            choice.eastM() - at.y(),
            now.stops() ? climbing.inside(plane, at.z(), vehicle.downMps(), downM) : downM),
        now.stops() ? choice.speedMps() : Situation.wantedMps(wanted, now),
        choice.backwards(),
        givenUp);
  }

  private ArcChooser arcs(
      Situation now, Vehicle vehicle, List<Mover> traffic, Optional<VerticalRoom> room) {
    double heading = now.pose().headingRad();
    double along = vehicle.northMps() * Math.cos(heading) + vehicle.eastMps() * Math.sin(heading);
    return new ArcChooser(
        world.costs(),
        now.body(),
        traffic,
        now.limits(),
        now.pose(),
        along,
        now.micros(),
        before,
        room,
        drift.drift());
  }

  private static boolean isNear(List<Mover> traffic, Situation now) {
    var limits = now.limits();
    double kept = now.body().circleM() + limits.trafficM() + limits.lookAheadM();
    return TrafficHold.isNear(traffic, now.pose(), kept, limits.horizonS(), now.micros());
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
