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
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.PathStatus;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.safety.FenceState;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.guidance.LineSettings;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.local.ArcChoice;
import org.u2sa.planning.local.ArcChooser;
import org.u2sa.planning.local.RouteTrack;
import org.u2sa.planning.local.StopSpeed;
import org.u2sa.planning.local.VerticalRoom;
import org.u2sa.planning.route.RoutePlanner;
import org.u2sa.planning.route.RoutePlanners;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.search.CostGrid;
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
  private static final double IN_PLACE_M = 2.0; // beside or above, within which it is at a place
  private static final double STILL_MPS = 0.1; // slower motion has no direction

  private final Supplier<String> chosen;
  private final Supplier<AvoidanceVariables> settings;
  private final Supplier<LineSettings> lines;
  private final BiConsumer<String, Boolean> say; // receives a message, and whether it is a warning
  private final SeenWorld world;
  private final Passages passages;
  private final VirtualObstacles obstacles;
  private final RouteKeeper routes;
  private final PathNews news;
  private final VerticalEvasion climbing;
  private final RouteGround highGround;
  private final StraightFlight straight;
  private final VerticalGuard vertical;
  private final InPlaceEvasion inPlace;
  private final DriftWatch drift;
  private final HoverEvasion hover;
  private PlanningPlane plane;
  private Optional<GoalAttempt> attempt = Optional.empty(); // set at the first step
  private Optional<ArcChoice> before = Optional.empty(); // last choice, on the plane
  private Optional<HeldChoice> held = Optional.empty();
  private long steppedMicros = Long.MIN_VALUE; // state of the last step
  private Optional<Place> began = Optional.empty(); // where the first step was made
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
      return new Wanted(goal, target.orAltitudeOf(altitude), thresholdM, headingRad, speedMps);
    }
  }

  /**
   * @param configuration configuration of the planner, in which PLANNER selects the route planner
   * @param say reports a message to the operator; true for a warning
   * @param terrain the ground, if it is known
   * @param slope slope of climbs and descents of aircraft without EVASION CLIMB
   */
  public Avoidance(
      Configurator configuration,
      Supplier<AvoidanceVariables> settings,
      Supplier<LineSettings> lines,
      BiConsumer<String, Boolean> say,
      Optional<HeightGrid> terrain,
      DoubleSupplier slope) {
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
                "NONE ignores obstacles; GRID avoids them for vehicles that turn in place, "
                    + "HYBRID for vehicles with a minimum turn radius; other names are planners of "
                    + "extensions.");
    chosen = () -> configuration.getVariable(planner);
    chosen.get(); // an invalid value must fail before the vehicle moves
    passages = new Passages(settings, this::turnsOnTheSpot);
    world = new SeenWorld(passages::reading);
    obstacles = new VirtualObstacles(world);
    routes = new RouteKeeper(world, obstacles, passages, () -> planners.get(chosen.get()), say);
    news = new PathNews(settings, say);
    GroundMap map = new GroundMap(terrain);
    climbing = new VerticalEvasion(map, say);
    highGround = new RouteGround(map, world, slope);
    straight = new StraightFlight(world);
    vertical = new VerticalGuard(world, say);
    drift = new DriftWatch(settings);
    inPlace = new InPlaceEvasion(world, climbing, settings, lines, say, this::arcs);
    hover = new HoverEvasion(world, climbing, settings, lines, say);
  }

  /** Estimates the drift of the vehicle, whatever its goal. */
  public void see(Vehicle vehicle) {
    drift.see(vehicle);
  }

  public boolean isOn() {
    return !chosen.get().equals(NONE);
  }

  public SeenWorld world() {
    return world;
  }

  /** Receives the fence in force: evasions in place, or from it, keep away from its limits. */
  public void see(FenceState fence) {
    climbing.see(fence);
    inPlace.see(fence);
    hover.see(fence);
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
    held = Optional.empty();
    routes.begin();
    highGround.begin();
    obstacles.forgetGaps();
    passages.widen();
    news.begin();
  }

  /**
   * Whether something is in the way of a vehicle that flies straight to a position: an obstacle
   * near the line, or traffic.
   */
  public boolean isHindered(Vehicle vehicle, StateInformation state, Place to) {
    boolean hasTraffic = comesTraffic(vehicle, state, to);
    AvoidanceVariables now = settings.get();
    return straight.isObstructed(vehicle, vehicle.on(plane), to, body(now), now) || hasTraffic;
  }

  /**
   * Whether ground is too high for a straight way to a position, with a climb or descent at once;
   * level to one without altitude.
   */
  public boolean isGroundBetween(Vehicle vehicle, StateInformation state, Place to) {
    AvoidanceVariables now = settings.get();
    lieOn(world.plane(state));
    return state.z().isPresent()
        && highGround.isBetween(
            plane, vehicle.on(plane), vehicle.nedOf(to), speedMps(vehicle, now), now);
  }

  /**
   * Likewise, of a straight way from anywhere that the vehicle leaves on the way: its end is no
   * goal.
   */
  public boolean isGroundAhead(Vehicle vehicle, StateInformation state, Place from, Place to) {
    AvoidanceVariables now = settings.get();
    lieOn(world.plane(state));
    Point ahead = vehicle.nedOf(from);
    return state.z().isPresent()
        && highGround.isAhead(
            plane,
            vehicle.on(plane).plus(ahead),
            vehicle.nedOf(to).minus(ahead),
            speedMps(vehicle, now),
            now);
  }

  private static double speedMps(Vehicle vehicle, AvoidanceVariables now) {
    return Math.max(vehicle.speedMps(), Math.max(now.minSpeed(), now.plannedSpeed()));
  }

  /** Whether ground is too high at a place of a circle about a centre of the same altitude. */
  public boolean isGroundAt(Vehicle vehicle, StateInformation state, Place place, Place centre) {
    lieOn(world.plane(state));
    Point at = vehicle.on(plane);
    return state.z().isPresent()
        && place.upM().isPresent()
        && highGround.isAt(
            plane, at.plus(vehicle.nedOf(place)), at.plus(vehicle.nedOf(centre)), settings.get());
  }

  /**
   * Whether a static obstacle, as of the last update, is too close to a straight descent to a point
   * on the ground. Near the ground, the required distance equals the aircraft's height.
   */
  public boolean blocksDescent(Vehicle vehicle, StateInformation state, Place from, Place to) {
    AvoidanceVariables now = settings.get();
    Point at = vehicle.on(world.plane(state));
    return straight.blocksDescent(vehicle, at, from, to, body(now), now);
  }

  /**
   * Whether traffic comes close within the horizon if the vehicle flies straight on.
   *
   * @param to point to which it climbs or descends
   */
  public boolean comesTraffic(Vehicle vehicle, StateInformation state, Place to) {
    AvoidanceVariables now = settings.get();
    lieOn(world.plane(state));
    Point at = vehicle.on(plane);
    world.update(state, at.x(), at.y(), at.z(), at.z() + vehicle.nedOf(to).z());
    return straight.comesTraffic(vehicle, at, body(now), now);
  }

  /** Whether a straight way to a position leads into something that stands. */
  public boolean isBlocked(Vehicle vehicle, StateInformation state, Place to) {
    return blocker(vehicle, state, vehicle.nedOf(to)).isPresent();
  }

  /**
   * Room of a vehicle on a surface where it is.
   *
   * @param to position to which it would move straight
   */
  public SurfaceRoom room(Vehicle vehicle, StateInformation state, Place to) {
    AvoidanceVariables now = settings.get();
    lieOn(world.plane(state));
    Point at = vehicle.on(plane);
    Point way = vehicle.nedOf(to);
    world.update(state, at.x(), at.y(), at.z(), at.z() + way.z());
    CostGrid costs = world.costs();
    double touchM = now.touchM(costs.frame().cellM());
    double turnRadiusM = Situation.turnRadiusM(now, lines.get(), vehicle.speedMps());
    return new SurfaceRoom(costs, body(now), at, vehicle.headingRad(), way, touchM, turnRadiusM);
  }

  /**
   * Speed of a vehicle on a surface that moves straight to where it stops [m/s]: the wanted one, or
   * less to stop there, before what stands beyond, and before what stands where it is moving to.
   *
   * @param berths whether it moves along the straight way to a berth, which may be narrow
   */
  public double straightMps(
      Vehicle vehicle, StateInformation state, Wanted wanted, boolean berths) {
    SurfaceRoom room = room(vehicle, state, wanted.target());
    StopSpeed speed = stopSpeed(vehicle, wanted);
    double cellM = room.grid().frame().cellM();
    double reachM = cellM + speed.reachM(vehicle.speedMps());
    double freeM = berths ? room.freeInBerthM(reachM) : room.freeAlongWayM(reachM);
    double closing = room.alongWay(vehicle.northMps(), vehicle.eastMps());
    double thatWay = speed.mps(Math.min(room.wayM(), freeM - cellM), closing);
    if (berths || vehicle.speedMps() <= STILL_MPS) {
      return thatWay;
    }
    double aheadM = room.freeM(vehicle.courseRad(), reachM) - cellM;
    return Math.min(thatWay, speed.mps(aheadM, vehicle.speedMps()));
  }

  /** Speed from which the vehicle stops where its route ends, or at the goal without one [m/s]. */
  public double stoppableMps(Vehicle vehicle, Wanted wanted) {
    Point toGo = vehicle.nedOf(wanted.target());
    double wayM = Math.max(Math.hypot(toGo.x(), toGo.y()), remainingM().orElse(0.0));
    return stopSpeed(vehicle, wanted).mps(wayM, vehicle.speedMps());
  }

  private StopSpeed stopSpeed(Vehicle vehicle, Wanted wanted) {
    AvoidanceVariables now = settings.get();
    return new StopSpeed(Situation.limits(vehicle, wanted, now, lines.get(), now.planningCell()));
  }

  private Optional<String> blocker(Vehicle vehicle, StateInformation state, Point way) {
    AvoidanceVariables now = settings.get();
    lieOn(world.plane(state));
    Point at = vehicle.on(plane);
    world.update(state, at.x(), at.y(), at.z(), at.z() + way.z());
    return straight.blocker(at, way, body(now), now);
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
    String stands = blocker(vehicle, state, way).orElse("");
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

  private void lieOn(PlanningPlane now) {
    if (now != plane) {
      plane = now;
      held = Optional.empty();
      before = Optional.empty();
      obstacles.forgetAll();
      highGround.begin();
    }
  }

  /** Returns path changes for displays once; empty if none. */
  public Optional<PlannedPath> news() {
    return news.take();
  }

  private BodyDiscs body(AvoidanceVariables now) {
    return now.body(turnsOnTheSpot());
  }

  /** The next step to a goal; to one without altitude, at that at which it began. */
  public Step step(Vehicle vehicle, StateInformation state, Wanted goal) {
    AvoidanceVariables now = settings.get();
    long micros = vehicle.timestampMicros();
    lieOn(world.plane(state));
    Wanted wanted = now.verticalClearance() > 0.0 ? goal.at(altitude(vehicle)) : goal;
    Point at = vehicle.on(plane);
    Point toGoal = vehicle.nedOf(wanted.target());
    if (held.isPresent() && held.get().isFor(wanted, micros)) {
      return step(held.get().choice(), vehicle, at, toGoal, wanted, Optional.empty());
    }
    GoalAttempt current = attempt.orElseGet(() -> new GoalAttempt(routes, passages, say, micros));
    attempt = Optional.of(current);
    world.overlook(current.overlooks(now, micros));
    // An aircraft moves along its course, not its heading.
    double ahead = now.stops() ? vehicle.headingRad() : vehicle.courseRad();
    Pose pose = new Pose(at.x(), at.y(), ahead);
    steppedMicros = micros;
    if (!now.passSides().isEmpty()) {
      obstacles.keepSides(pose, state, routes.track(), now);
    }
    boolean hasAltitudes = state.z().isPresent() && wanted.target().upM().isPresent();
    double speedMps = Math.max(vehicle.speedMps(), Situation.wantedMps(wanted, now));
    Optional<String> inGround = highGround.see(plane, at, toGoal, hasAltitudes, speedMps, now);
    world.update(state, at.x(), at.y(), at.z(), at.z() + toGoal.z());
    Situation situation =
        Situation.of(
            pose, toGoal, wanted, vehicle, world.costs().frame().cellM(), now, lines.get());
    routes.update(situation);
    Optional<VerticalRoom> room =
        climbing
            .room(state, at, toGoal, wanted.target(), now, world, plane, Optional.empty())
            .map(each -> now.stops() ? each.descendingTo(highGround::lowestM) : each);
    List<Mover> traffic = room.isPresent() ? world.allMovers() : world.movers();
    ArcChoice choice = current.choose(arcs(situation, vehicle, traffic, room), situation);
    climbing.chosen(choice, at, micros);
    before = Optional.of(choice);
    Optional<String> givenUp =
        inGround.or(() -> current.judge(choice, isNear(traffic, situation), situation));
    PathStatus status = PathNews.status(choice, givenUp, current.hasRecovered(), routes);
    announce(status, givenUp, wanted, at);
    held = now.stops() ? Optional.empty() : Optional.of(new HeldChoice(choice, wanted, micros));
    return step(choice, vehicle, at, toGoal, wanted, givenUp);
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
