package org.u2sa.planning.avoidance;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.goals.GoalRecheck;
import org.u2sa.planning.local.ArcChoice;
import org.u2sa.planning.local.RouteTrack;
import org.u2sa.planning.route.Route;
import org.u2sa.planning.route.RoutePlanner;
import org.u2sa.planning.route.RouteRequest;
import org.u2sa.planning.route.RouteRequest.Mobility;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.search.GridFrame;
import org.u2sa.planning.seen.PlanarShape;
import org.u2sa.planning.seen.SeenWorld;

/**
 * Maintains a route to the goal: replans when there is none, when it is blocked or was left, and
 * when a better one may exist. Confined to the planner's thread.
 */
final class RouteKeeper {
  /** Hysteresis: maximum cost of a new route, as a fraction of the old route's remaining cost. */
  private static final double BETTER = 0.9;

  private static final double TURN_MARGIN = 1.05; // routes turn wider than the vehicle can

  /** Distance within which a route must have left closed cells [radii with clearance]. */
  private static final double LEAVES_RADII = 2.0;

  private static final double CLOSE_M = 3.0; // from a goal, to see what is there
  private static final double CLOSE = 3.0; // likewise, in radii at least
  private static final double LOOKS_M = 1.0; // shorter ways are not worth it

  private static final double STOPS_SHORT_M = 0.15; // TOLERANCE of a control, by default
  private static final double STOPS_SHORT = 0.3; // likewise, in thresholds at most

  private static final String NO_WAY = "obstacles leave no way to the goal";
  private static final double MISALIGNED_RAD = Math.toRadians(5.0); // as HYBRID aims
  private static final int MAX_DOUBLINGS = 4; // doublings of the wait after failed searches

  private final SeenWorld world;
  private final VirtualObstacles obstacles;
  private final Passages passages;
  private final Supplier<RoutePlanner> planner;
  private final BiConsumer<String, Boolean> say;

  private BooleanSupplier climbs = () -> false; // whether it can climb above ground in the way
  private Optional<RouteTrack> track = Optional.empty();
  private String obstacle = ""; // reason for the absence of a route
  private boolean searches; // search in progress: no route until it ends
  private int revision; // world revision last checked
  private int triedRevision = -1; // world revision of the last search
  private boolean triesAhead; // looks for a route that does not lead back
  private long aheadUntil; // time at which it also admits routes that do [µs]
  private final GoalRecheck look = new GoalRecheck();
  private boolean triesNearer; // the route ends short of the goal, and narrower passages are new
  private int failures; // failed searches, one after the other
  private long plannedMicros = Long.MIN_VALUE / 2;

  /**
   * @param planner the configured planner
   * @param say reports a message to the operator; true for a warning
   */
  RouteKeeper(
      SeenWorld world,
      VirtualObstacles obstacles,
      Passages passages,
      Supplier<RoutePlanner> planner,
      BiConsumer<String, Boolean> say) {
    this.world = world;
    this.obstacles = obstacles;
    this.passages = passages;
    this.planner = planner;
    this.say = say;
  }

  void begin() {
    dropUntil(Long.MIN_VALUE / 2);
    obstacle = "";
    triesAhead = false;
    triesNearer = false;
    look.begin();
  }

  /** Drops the route. The next one is planned from the pose at a time [µs]. */
  void dropUntil(long micros) {
    track = Optional.empty();
    searches = false;
    failures = 0;
    plannedMicros = micros;
    tryAgain();
  }

  /** Replans although the world is unchanged since no route was found. */
  void tryAgain() {
    triedRevision = -1;
  }

  /** Whether the ground where a motion ends was neither seen nor passed. */
  boolean endsUnseen(ArcChoice choice) {
    return world.costs().isUnseen(choice.northM(), choice.eastM());
  }

  /**
   * Looks for a route ahead, through narrow passages too, although one leads back over ground that
   * was never seen, where the vehicle cannot turn. If none is found until a time [µs], the next
   * route may lead back.
   */
  void tryAhead(Situation now, long until) {
    triesAhead = true;
    aheadUntil = until;
    obstacles.closeUnseen(now.pose(), now.body().circleM() + now.settings().clearance());
    passages.narrow();
    say.accept("the way leads back, where nothing was seen: trying the way ahead", false);
    dropUntil(now.micros() - now.settings().replanMicros());
  }

  /** The route, with the vehicle's progress along it. */
  Optional<RouteTrack> track() {
    return track;
  }

  String obstacle() {
    return obstacle;
  }

  boolean isSearching() {
    return searches;
  }

  /** Whether the last search, in the world as it is, has found no route. */
  boolean isHopeless() {
    return track.isEmpty() && !searches && triedRevision == world.revision();
  }

  /** Sets whether the vehicle can climb above ground in the way: far around is then no way. */
  void climbsIf(BooleanSupplier canClimb) {
    climbs = canClimb;
  }

  /** Updates the vehicle's progress along the route, and the route. */
  void update(Situation now) {
    double off = track.map(route -> follow(route, now)).orElse(0.0);
    if (look.isUnderWay() && (track.isEmpty() || track.get().remainingM() < LOOKS_M)) {
      track = Optional.empty(); // it is there, and waits for a way to the goal
      look.wayFound();
      tryAgain();
    }
    if (lacksWay() && look.begins(now.settings().stops() && isFar(now), now.micros())) {
      tryAgain();
    }
    double leftM = Math.max(now.limits().lookAheadM(), 0.5 * now.limits().turnRadiusM());
    boolean changed = world.revision() != revision;
    boolean blocked = changed && track.isPresent() && costLeft(now) == Double.POSITIVE_INFINITY;
    boolean due = now.micros() - plannedMicros >= now.settings().replanMicros();
    boolean hopeless = track.isEmpty() && world.revision() == triedRevision && !isElsewhere(now);
    boolean lacking = track.isEmpty() && (searches || (due && !hopeless));
    revision = world.revision();
    if (blocked && now.settings().stops()) {
      obstacles.blocked(track.get(), now.micros());
    }
    if (goalMoved(now) || lacking || blocked || due && (off > leftM || triesNearer)) {
      replace(plan(now), now);
    } else if (endsMisaligned(now) && (due || searches)) {
      Route route = plan(now);
      searches = route.goesOn();
      if (route.exists()) {
        track = Optional.of(new RouteTrack(route));
      }
    } else if (changed && due || look.isUnderWay() && searches) {
      Route route = plan(now);
      searches = look.isUnderWay() && route.goesOn();
      boolean isBetter = look.isUnderWay() || route.cost() < BETTER * costLeft(now);
      if (route.exists() && isBetter) {
        track = Optional.of(new RouteTrack(route));
        look.wayFound();
      }
    }
  }

  /**
   * Whether a vehicle that has to steer is at the end of its route without the heading wanted
   * there: it has not followed the route closely enough.
   */
  private boolean endsMisaligned(Situation now) {
    if (track.isEmpty() || now.goalHeadingRad().isEmpty() || now.slowRadiusM() == 0.0) {
      return false;
    }
    double off = Pose.wrapped(now.goalHeadingRad().getAsDouble() - now.pose().headingRad());
    return now.settings().stops()
        && track.get().isAtEnd(reachedM(now))
        && Math.abs(off) > MISALIGNED_RAD;
  }

  /** Distance within which a cusp of the route counts as reached [m]. */
  private static double reachedM(Situation now) {
    return Math.min(0.25 * now.limits().lookAheadM(), 3.0 * now.cellM());
  }

  private boolean lacksWay() {
    return track.isEmpty() && !searches && !triesAhead && !obstacle.isEmpty();
  }

  private static boolean isFar(Situation now) {
    double awayM =
        Math.hypot(now.goalNorthM() - now.pose().northM(), now.goalEastM() - now.pose().eastM());
    return awayM > closeM(now) + LOOKS_M;
  }

  /** Distance from a goal at which the vehicle sees what is there [m]. */
  private static double closeM(Situation now) {
    return Math.max(CLOSE_M, CLOSE * now.body().circleM()) + now.thresholdM();
  }

  /**
   * Whether a vehicle that cannot stop may have room to turn since the last search. A failed search
   * takes long, so the wait doubles after each.
   */
  private boolean isElsewhere(Situation now) {
    long wait = now.settings().replanMicros() << Math.min(failures, MAX_DOUBLINGS);
    return !now.settings().stops() && now.micros() - plannedMicros >= wait;
  }

  /** Distance of the vehicle off the route [m]. */
  private double follow(RouteTrack route, Situation now) {
    return route.follow(
        now.pose().northM(), now.pose().eastM(), reachedM(now), now.limits().lookAheadM());
  }

  private boolean goalMoved(Situation now) {
    if (track.isEmpty()) {
      return false;
    }
    int last = track.get().count() - 1;
    double moved =
        Math.hypot(
            track.get().northM(last) - now.goalNorthM(), track.get().eastM(last) - now.goalEastM());
    return moved > (look.isUnderWay() ? closeM(now) : now.thresholdM()) + now.cellM();
  }

  private void replace(Route route, Situation now) {
    if (look.isSought() && !route.goesOn()) {
      looked(route.exists());
    } else if (route.exists()) {
      look.wayFound();
    }
    triesNearer = !look.isUnderWay() && endsShort(route, now) && passages.narrow();
    if (triesNearer) {
      say.accept("obstacles at the goal: trying narrower passages", false);
    }
    track = route.exists() ? Optional.of(new RouteTrack(route)) : Optional.empty();
    obstacle = reason(route);
    searches = route.goesOn();
    triedRevision = revision; // a longer search may have missed recent changes
    if (route.exists()) {
      failures = 0;
      triesAhead = false;
    } else if (triesAhead) {
      goOnOrTurnBack();
    } else if (!route.goesOn()) {
      failures++;
      obstacles.forgetGaps();
      if (passages.narrow()) {
        tryAgain();
        say.accept("no route with room to turn: trying narrower passages", false);
      }
    }
  }

  private void looked(boolean isPossible) {
    if (isPossible) {
      look.starts();
      say.accept("no way to the goal: going nearer, to see what is there", false);
    } else {
      look.fails();
    }
  }

  /**
   * Whether a route ends so near the edge of the goal's threshold that a control which stops a
   * little short of its end would never reach the goal.
   */
  private static boolean endsShort(Route route, Situation now) {
    if (!route.exists()) {
      return false;
    }
    Route.Point last = route.points().get(route.points().size() - 1);
    double offM = Math.hypot(last.northM() - now.goalNorthM(), last.eastM() - now.goalEastM());
    double shortM = Math.min(STOPS_SHORT_M, STOPS_SHORT * now.thresholdM());
    return offM > now.thresholdM() - shortM && offM <= now.thresholdM() + now.cellM();
  }

  /** Goes on looking for a route ahead, or admits all others again. */
  private void goOnOrTurnBack() {
    tryAgain();
    if (plannedMicros >= aheadUntil) {
      triesAhead = false;
      obstacles.forgetGaps();
      passages.widen();
    }
  }

  private String reason(Route route) {
    return route.exists() || route.goesOn() || !world.hasHighGround()
        ? route.obstacle()
        : route.obstacle() + " (ground that is too high counts as one)";
  }

  private Route plan(Situation now) {
    plannedMicros = now.micros();
    if (!searches) {
      triedRevision = world.revision();
    }
    AvoidanceVariables settings = now.settings();
    Route route =
        planner
            .get()
            .plan(
                new RouteRequest(
                    now.pose(),
                    now.goalNorthM(),
                    now.goalEastM(),
                    now.goalHeadingRad(),
                    look.isSought() ? closeM(now) : now.thresholdM(),
                    new Mobility(
                        passages.body(),
                        settings.clearance(),
                        TURN_MARGIN * now.slowRadiusM(),
                        settings.reverses()),
                    world.costs(),
                    shapes(now),
                    world.corridors(),
                    settings.effort()));
    return isNoWay(route, now) ? Route.none(NO_WAY) : route;
  }

  /**
   * Whether ground beyond the window, which is too high, leaves a vehicle that can stop no way from
   * where a route leaves the window, or one that can climb above it only a way that is longer than
   * the straight one by more than the window's edge.
   */
  private boolean isNoWay(Route route, Situation now) {
    GridFrame frame = world.costs().frame();
    if (!route.exists() || frame.contains(now.goalNorthM(), now.goalEastM())) {
      return false;
    }
    double north = now.pose().northM();
    double east = now.pose().eastM();
    double lengthM = 0.0;
    for (Route.Point point : route.points()) {
      if (!frame.contains(point.northM(), point.eastM())) {
        break;
      }
      lengthM += Math.hypot(point.northM() - north, point.eastM() - east);
      north = point.northM();
      east = point.eastM();
    }
    double onM = world.costs().beyondM(north, east, now.goalNorthM(), now.goalEastM());
    boolean isStraight = onM <= Math.hypot(now.goalNorthM() - north, now.goalEastM() - east);
    double straightM = now.pose().distanceM(now.goalNorthM(), now.goalEastM());
    boolean isFar = !isStraight && lengthM + onM > straightM + frame.rows() * frame.cellM();
    boolean isClosed = now.settings().stops() && !world.costs().leadsOn(north, east);
    return isClosed || isFar && climbs.getAsBoolean();
  }

  /** Obstacles; high ground only if its outline without dents leaves out vehicle and goal. */
  private List<PlanarShape> shapes(Situation now) {
    List<PlanarShape> ground = world.highGround();
    if (ground.isEmpty()) {
      return world.shapes();
    }
    List<PlanarShape> all = new ArrayList<>(world.shapes());
    for (PlanarShape high : ground) {
      boolean contains =
          high.distanceM(now.pose().northM(), now.pose().eastM()) == 0.0
              || high.distanceM(now.goalNorthM(), now.goalEastM()) == 0.0;
      if (!contains) {
        all.add(high);
      }
    }
    return all;
  }

  /** Current cost of the rest of the route [m]; infinite if it is blocked. */
  private double costLeft(Situation now) {
    CostGrid costs = world.costs();
    RouteTrack route = track.get();
    double north = route.northAheadM(0.0);
    double east = route.eastAheadM(0.0);
    double sum = 0.0;
    for (int i = route.next(); i < route.count(); i++) {
      double cost = costs.straightCost(north, east, route.northM(i), route.eastM(i));
      boolean besideStart = i == route.next() && cost == Double.POSITIVE_INFINITY;
      if (besideStart && costs.cost(north, east) == Double.POSITIVE_INFINITY) {
        cost = leavingM(north, east, route.northM(i), route.eastM(i), now.body().halfWidthM());
      }
      sum += cost;
      north = route.northM(i);
      east = route.eastM(i);
    }
    return sum;
  }

  /**
   * Cost of a straight way out of closed cells [m]: the vehicle must fit, and the way be free after
   * a short distance.
   */
  private double leavingM(
      double north, double east, double toNorth, double toEast, double halfWidthM) {
    CostGrid costs = world.costs();
    double length = Math.hypot(toNorth - north, toEast - east);
    double out = Math.max(LEAVES_RADII * costs.inflation().radiusM(), costs.frame().cellM());
    double share = Math.min(1.0, out / length);
    double outNorth = north + share * (toNorth - north);
    double outEast = east + share * (toEast - east);
    if (!costs.leadsOut(north, east, outNorth, outEast, halfWidthM)) {
      return Double.POSITIVE_INFINITY;
    }
    return length <= out ? length : out + costs.straightCost(outNorth, outEast, toNorth, toEast);
  }
}
