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
import org.u2sa.messages.PathStatus;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.guidance.LineSettings;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.local.ArcChoice;
import org.u2sa.planning.local.ArcChooser;
import org.u2sa.planning.local.MotionLimits;
import org.u2sa.planning.local.RouteTrack;
import org.u2sa.planning.route.HousePlanners;
import org.u2sa.planning.route.Mobility;
import org.u2sa.planning.route.Route;
import org.u2sa.planning.route.RoutePlanner;
import org.u2sa.planning.route.RouteRequest;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.seen.PlanningPlane;
import org.u2sa.planning.seen.SeenWorld;

/**
 * Avoids the obstacles in the world model: plans a route, follows it past traffic, replans when it
 * is blocked or a better one exists, frees a stuck vehicle, and gives up with a reason. Confined to
 * the planner's thread.
 */
public final class Avoidance {
  private static final String NONE = "NONE";

  /** A moving vehicle restarts its search, which may therefore not terminate. */
  private static final String NOT_IN_TIME = "no way to the goal was found in time";

  /**
   * Hysteresis: a new route replaces the old one if it costs no more than this share of the old
   * one's remainder.
   */
  private static final double BETTER = 0.9;

  /** Below this share of its speed, a vehicle that cannot hover or stop has not taken off. */
  private static final double SHARE_FLYING = 0.5;

  /** Smaller movements do not count as progress [cells]. */
  private static final double PROGRESS_CELLS = 2.0;

  private final Supplier<String> chosen;
  private final Map<String, RoutePlanner> planners;
  private final Supplier<AvoidanceSettings> settings;
  private final Supplier<LineSettings> lines;
  private final BiConsumer<String, Boolean> say; // message, and whether it is a warning
  private final SeenWorld world;
  private final Passages passages;
  private final Guesses guesses;
  private final Nearing nearing = new Nearing();
  private final TrafficHold hold = new TrafficHold();
  private final LookAround lookAround = new LookAround();
  private final PathNews news;
  private PlanningPlane plane;

  private Optional<RouteTrack> track = Optional.empty();
  private String obstacle = ""; // reason for the absence of a route
  private boolean searches; // search in progress: no route until it ends
  private double goalNorthM;
  private double goalEastM;
  private int revision; // world revision last checked
  private int triedRevision = -1; // world revision of the last search
  private long plannedMicros;
  private long routelessSince;
  private long progressMicros;
  private double leastRemainingM;
  private int recoveries;
  private long recoversUntil;
  private long overlooksUntil = Long.MIN_VALUE;
  private boolean makesRoom; // to turn in place
  private boolean begun;

  /**
   * Next step of the vehicle.
   *
   * @param ned vector from the vehicle [m]; down is unset
   * @param speedMps speed [m/s]
   * @param backwards whether in reverse
   * @param givenUp reason for giving up the goal, or empty
   */
  public record Step(Point ned, double speedMps, boolean backwards, Optional<String> givenUp) {}

  /** Requirements of a goal. */
  public record Wanted(
      String goal,
      Place target,
      double thresholdM,
      OptionalDouble headingRad,
      OptionalDouble speedMps) {}

  /**
   * @param configuration configuration of the planner, in which PLANNER selects the route planner
   * @param say reports a message to the operator; true for a warning
   */
  public Avoidance(
      Configurator configuration,
      Supplier<AvoidanceSettings> settings,
      Supplier<LineSettings> lines,
      BiConsumer<String, Boolean> say) {
    this.settings = settings;
    this.lines = lines;
    this.say = say;
    planners = new LinkedHashMap<>(HousePlanners.all(configuration));
    List<String> names = new ArrayList<>(planners.keySet());
    names.add(0, NONE);
    VariableDeclaration<String> planner =
        VariableDeclaration.text("PLANNER")
            .oneOf(names.toArray(new String[0]))
            .ifAbsent(NONE)
            .describedAs(
                "NONE sees no obstacles; GRID plans around them for vehicles that turn on the spot, HYBRID for those with a turning circle; others are planners of extensions.");
    chosen = () -> configuration.getVariable(planner);
    chosen.get(); // an invalid value must fail before the vehicle moves
    passages = new Passages(settings, this::turnsOnTheSpot);
    world = new SeenWorld(passages::reading);
    guesses = new Guesses(world);
    news = new PathNews(settings, say);
  }

  /** Whether route planning is enabled. */
  public boolean isOn() {
    return !chosen.get().equals(NONE);
  }

  /** World as received from the World Modeler. */
  public SeenWorld world() {
    return world;
  }

  /** Whether the vehicle can turn in place. */
  public boolean turnsOnTheSpot() {
    return turnRadiusM(0.0) == 0.0;
  }

  /** Remaining length of the route [m]; empty without one. */
  public OptionalDouble remainingM() {
    return track.isPresent() ? OptionalDouble.of(track.get().remainingM()) : OptionalDouble.empty();
  }

  /** Called when another goal is started. */
  public void begin() {
    track = Optional.empty();
    begun = false;
    obstacle = "";
    searches = false;
    guesses.forgetGaps();
    passages.widen();
    recoveries = 0;
    recoversUntil = Long.MIN_VALUE;
    overlooksUntil = Long.MIN_VALUE;
    news.begin();
  }

  /** Called when a waypoint was reached: closes the way back. */
  public void reached(Vehicle vehicle, StateInformation state) {
    AvoidanceSettings now = settings.get();
    if (now.closeBehind() > 0.0) {
      lieOn(world.plane(state));
      Point at = vehicle.on(plane);
      Pose pose = new Pose(at.x(), at.y(), vehicle.headingRad());
      guesses.closeBehind(pose, body(now).circleM(), now.closeBehind());
    }
  }

  private void lieOn(PlanningPlane now) {
    if (now != plane) {
      plane = now;
      guesses.forgetAll();
    }
  }

  /** Returns path changes for displays once; empty if none. */
  public Optional<PlannedPath> news() {
    return news.take();
  }

  private BodyDiscs body(AvoidanceSettings now) {
    return now.body(turnsOnTheSpot());
  }

  private double turnRadiusM(double speedMps) {
    AvoidanceSettings now = settings.get();
    double speed = Math.max(speedMps, Math.max(now.plannedSpeed(), now.leastSpeed()));
    return now.turnRadius() > 0.0 ? now.turnRadius() : lines.get().turns().radiusM(speed);
  }

  /** Plans the next step to a goal. */
  public Step step(Vehicle vehicle, StateInformation state, Wanted wanted) {
    AvoidanceSettings now = settings.get();
    long micros = vehicle.timestampMicros();
    lieOn(world.plane(state));
    Point at = vehicle.on(plane);
    Point toGoal = vehicle.nedOf(wanted.target());
    goalNorthM = at.x() + toGoal.x();
    goalEastM = at.y() + toGoal.y();
    overlook(now, micros);
    // An aircraft moves along its course, not its heading.
    double ahead = now.stops() ? vehicle.headingRad() : vehicle.courseRad();
    Pose pose = new Pose(at.x(), at.y(), ahead);
    if (!now.passSides().isEmpty()) {
      guesses.keepSides(pose, state, track, now);
    }
    world.update(state, at.x(), at.y(), at.z(), at.z() + toGoal.z());
    if (!begun) {
      begun = true;
      progressMicros = micros;
      nearing.begin(micros);
      hold.begin(micros);
      routelessSince = micros;
      leastRemainingM = Double.POSITIVE_INFINITY;
      plannedMicros = Long.MIN_VALUE / 2;
      triedRevision = -1;
    }
    MotionLimits limits = limits(vehicle, wanted, now);
    double off =
        track.map(t -> t.follow(at.x(), at.y(), reachedM(limits), limits.lookAheadM())).orElse(0.0);
    maintain(pose, wanted, limits, now, micros, off);
    ArcChoice choice = choose(pose, vehicle, limits, now, micros);
    makesRoom = choice.kind() == ArcChoice.Kind.MAKE_ROOM;
    leaveOut(hold.pass(choice.kind(), isTrafficNear(pose, limits, now, micros), micros));
    Optional<String> givenUp = progress(choice, limits, now, micros);
    announce(choice, givenUp, wanted, at);
    return new Step(
        Point.of(choice.northM() - at.x(), choice.eastM() - at.y(), toGoal.z()),
        now.stops() ? choice.speedMps() : wantedMps(wanted, now),
        choice.backwards(),
        givenUp);
  }

  /**
   * Discards guesses after a while without any route, because a gap may have been closed in error.
   */
  private void overlook(AvoidanceSettings now, long micros) {
    boolean isStuck = begun && track.isEmpty() && micros >= recoversUntil;
    if (now.overlookAfter() > 0.0 && isStuck && micros - routelessSince > now.overlookMicros()) {
      if (micros >= overlooksUntil) {
        say.accept("no way: passes through what is only guessed", false);
        triedRevision = -1;
      }
      overlooksUntil = micros + now.overlookMicros();
    }
    world.overlook(micros < overlooksUntil);
  }

  /** Wanted speed of the vehicle; airspeed for aircraft [m/s]. */
  private static double wantedMps(Wanted wanted, AvoidanceSettings now) {
    return Math.max(now.leastSpeed(), wanted.speedMps().orElse(now.plannedSpeed()));
  }

  private double reachedM(MotionLimits limits) {
    return Math.min(0.25 * limits.lookAheadM(), 3.0 * cellM());
  }

  /** Cell of the grid on which routes are planned at present [m]. */
  private double cellM() {
    return world.costs().frame().cellM();
  }

  private MotionLimits limits(Vehicle vehicle, Wanted wanted, AvoidanceSettings now) {
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
        now.touchM(cellM()),
        now.preferredClearance(),
        now.trafficClearance(),
        now.trafficHorizon(),
        now.reactionTime(),
        Math.toRadians(now.plannedTurnRate()));
  }

  /** Plans if there is no route, if it is blocked or was left, or if a better one may exist. */
  private void maintain(
      Pose pose,
      Wanted wanted,
      MotionLimits limits,
      AvoidanceSettings now,
      long micros,
      double off) {
    boolean changed = world.revision() != revision;
    boolean left = off > Math.max(limits.lookAheadM(), 0.5 * limits.turnRadiusM());
    boolean blocked = changed && track.isPresent() && costLeft() == Double.POSITIVE_INFINITY;
    boolean due = micros - plannedMicros >= now.replanMicros();
    boolean goalMoved =
        track.isPresent()
            && Math.hypot(
                    track.get().northM(track.get().count() - 1) - goalNorthM,
                    track.get().eastM(track.get().count() - 1) - goalEastM)
                > wanted.thresholdM() + cellM();
    boolean hopeless = track.isEmpty() && world.revision() == triedRevision;
    boolean lacking = track.isEmpty() && (searches || (due && !hopeless));
    revision = world.revision();
    if (blocked && now.stops()) {
      guesses.blocked(track.get(), micros);
    }
    if (goalMoved || lacking || blocked || (left && due)) {
      Route route = plan(pose, wanted, now, micros);
      obstacle = route.obstacle();
      searches = route.goesOn();
      take(route, micros);
      revision = triedRevision; // a longer search may have missed recent changes
      if (!route.exists() && !route.goesOn()) {
        guesses.forgetGaps();
        if (passages.narrow()) {
          triedRevision = -1;
          say.accept("no way with room to turn: tries narrower passages", false);
        }
      }
    } else if (changed && due) {
      Route route = plan(pose, wanted, now, micros);
      if (route.exists() && route.cost() < BETTER * costLeft()) {
        take(route, micros);
      }
    }
  }

  private Route plan(Pose pose, Wanted wanted, AvoidanceSettings now, long micros) {
    plannedMicros = micros;
    if (!searches) {
      triedRevision = world.revision();
    }
    return planners
        .get(chosen.get())
        .plan(
            new RouteRequest(
                pose,
                goalNorthM,
                goalEastM,
                wanted.headingRad(),
                wanted.thresholdM(),
                new Mobility(body(now), now.clearance(), 1.05 * turnRadiusM(0.0), now.reverses()),
                world.costs(),
                world.shapes(),
                world.corridors(),
                now.effort()));
  }

  private void take(Route route, long micros) {
    if (route.exists()) {
      track = Optional.of(new RouteTrack(route));
      leastRemainingM = Double.POSITIVE_INFINITY;
    } else {
      if (track.isPresent()) {
        routelessSince = micros;
      }
      track = Optional.empty();
    }
  }

  /** Current cost of the rest of the route [m]; infinite if it is blocked. */
  private double costLeft() {
    RouteTrack route = track.get();
    double north = route.northAheadM(0.0);
    double east = route.eastAheadM(0.0);
    double sum = 0.0;
    for (int i = route.next(); i < route.count(); i++) {
      double cost = world.costs().straightCost(north, east, route.northM(i), route.eastM(i));
      boolean besideStart = i == route.next() && cost == Double.POSITIVE_INFINITY;
      if (besideStart && isTooNear(north, east)) {
        cost = Math.hypot(route.northM(i) - north, route.eastM(i) - east); // it is leaving
      }
      sum += cost;
      north = route.northM(i);
      east = route.eastM(i);
    }
    return sum;
  }

  private boolean isTooNear(double north, double east) {
    return world.costs().cost(north, east) == Double.POSITIVE_INFINITY;
  }

  private ArcChoice choose(
      Pose pose, Vehicle vehicle, MotionLimits limits, AvoidanceSettings now, long micros) {
    double along =
        vehicle.northMps() * Math.cos(pose.headingRad())
            + vehicle.eastMps() * Math.sin(pose.headingRad());
    ArcChooser arcs =
        new ArcChooser(
            world.costs(), body(now), world.movers(), limits, pose, along, micros, makesRoom);
    if (micros < recoversUntil) {
      return arcs.backOut(1.5 * body(now).circleM());
    }
    if (track.isPresent()) {
      lookAround.end();
      return arcs.along(track.get());
    }
    boolean looks = now.overlookAfter() > 0.0 && micros - routelessSince > 2 * now.overlookMicros();
    return looks ? arcs.lookTo(lookAround.headingRad(pose, micros)) : arcs.withoutRoute();
  }

  private boolean isTrafficNear(
      Pose pose, MotionLimits limits, AvoidanceSettings now, long micros) {
    double kept = body(now).circleM() + limits.trafficM() + limits.lookAheadM();
    return TrafficHold.isNear(world.movers(), pose, kept, limits.horizonS(), micros);
  }

  private void leaveOut(long heldMicros) {
    progressMicros += heldMicros;
    routelessSince += heldMicros;
    nearing.leaveOut(heldMicros);
  }

  /** Checks progress and frees the vehicle if stuck; returns the reason for giving up. */
  private Optional<String> progress(
      ArcChoice choice, MotionLimits limits, AvoidanceSettings now, long micros) {
    if (track.isEmpty()) {
      progressMicros = micros;
      return micros - routelessSince >= now.giveUpMicros()
          ? Optional.of(searches ? NOT_IN_TIME : obstacle)
          : Optional.empty();
    }
    routelessSince = micros;
    double remaining = track.get().remainingM();
    if (remaining < leastRemainingM - PROGRESS_CELLS * cellM()) {
      leastRemainingM = remaining;
      progressMicros = micros;
    }
    Optional<String> circles =
        nearing.circles(
            remaining, PROGRESS_CELLS * cellM(), limits.speedMps(), now.stuckAfter(), micros);
    if (!now.stops() || circles.isPresent()) {
      return circles;
    }
    if (micros - progressMicros < now.stuckMicros() || micros < recoversUntil) {
      return Optional.empty();
    }
    if (recoveries >= now.recoveries()) {
      return Optional.of(
          choice.kind() == ArcChoice.Kind.WAIT
              ? "traffic or obstacles leave no room to move"
              : "stuck after " + recoveries + " attempts to free itself");
    }
    recoveries++;
    passages.widen();
    say.accept("stuck: frees itself, attempt " + recoveries + " of " + now.recoveries(), false);
    recoversUntil = micros + now.stuckMicros() / 3;
    progressMicros = recoversUntil;
    track = Optional.empty(); // replan from the resulting pose
    searches = false;
    plannedMicros = recoversUntil - now.replanMicros();
    triedRevision = -1;
    return Optional.empty();
  }

  private void announce(ArcChoice choice, Optional<String> givenUp, Wanted wanted, Point at) {
    PathStatus status;
    if (givenUp.isPresent()) {
      status = PathStatus.GIVEN_UP;
    } else if (choice.kind() == ArcChoice.Kind.BRAKE) {
      status = PathStatus.BRAKING;
    } else if (recoversUntil > 0L && track.isEmpty() && obstacle.isEmpty()) {
      status = PathStatus.RECOVERING;
    } else {
      status = choice.kind() == ArcChoice.Kind.WAIT ? PathStatus.WAITING : PathStatus.FOLLOWED;
    }
    news.announce(
        () -> new PlannedPath().goal(wanted.goal()).planner(chosen.get()),
        status,
        givenUp.orElse(obstacle),
        track,
        plane,
        at.z());
  }
}
