package org.u2sa.planning;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.function.Supplier;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Landing;
import org.u2sa.messages.goal.PayloadDrop;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.planning.avoidance.Avoidance;
import org.u2sa.planning.avoidance.AvoidanceVariables;
import org.u2sa.planning.goals.PursuitTime;
import org.u2sa.planning.guidance.AltitudeProgress;
import org.u2sa.planning.guidance.ApproachWatch;
import org.u2sa.planning.guidance.Leg;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.guidance.WaypointAccuracy;
import org.u2sa.planning.guidance.WaypointGuidance;
import org.u2sa.planning.rightofway.RightOfWayWatch;
import org.u2sa.planning.rightofway.RightOfWayWatch.Order;
import org.u2sa.service.handover.HandOver;

/**
 * Guides the vehicle to a waypoint.
 *
 * <p>The waypoint is reached within its horizontal threshold and, if it has one, its vertical
 * threshold (thesis 3.2.3.4), and is reported at the point of closest approach. After a miss the
 * vehicle turns round for another attempt; after the last attempt the waypoint is abandoned and
 * reported as such, also if a vehicle that can stop stands beside it.
 */
final class WaypointState implements PlannerState {
  /** Fraction of a threshold within which typical estimation errors do not hide a miss. */
  private static final double SHARE_NEAR = 0.8;

  /** Maximum gap between states; beyond it, as after a lost link, the path is unknown [µs]. */
  private static final long LONGEST_STEP_MICROS = 10 * Clock.MICROS_PER_SECOND;

  /** Below this speed the vehicle counts as stopped [m/s]. */
  private static final double CREEPS_MPS = 0.1;

  /** Time that a vehicle that can stop stays at a waypoint that is its own successor [µs]. */
  private static final long STAYS_MICROS = Clock.MICROS_PER_SECOND;

  private final WaypointGuidance guidance;
  private final Supplier<PlanningVariables> settings;
  private final Avoidance avoidance;
  private final RightOfWayWatch rightOfWay;
  private final Supplier<AvoidanceVariables> seeing;
  private final Detour detour;
  private final PursuitTime time;
  private final AltitudeProgress altitude = new AltitudeProgress();
  private final ApproachWatch beside = new ApproachWatch();
  private int attempts;
  private boolean armed; // false: must leave the threshold, or stay, before reaching it again
  private OptionalLong stayedMicros = OptionalLong.empty(); // start of the stay, while not armed
  private boolean reached;
  private boolean yields; // follows a right-of-way order
  private double nearestM; // minimum distance in this attempt, while approaching
  private double nowM; // current distance from the waypoint
  private Optional<StateInformation> last = Optional.empty();
  private Optional<Place> aimedAt = Optional.empty(); // position of the waypoint at the last state

  /**
   * @param time time against which patience with a waypoint is measured
   */
  WaypointState(
      WaypointGuidance guidance,
      Supplier<PlanningVariables> settings,
      Avoidance avoidance,
      RightOfWayWatch rightOfWay,
      Supplier<AvoidanceVariables> seeing,
      Detour detour,
      PursuitTime time) {
    this.detour = detour;
    this.time = time;
    this.guidance = guidance;
    this.settings = settings;
    this.avoidance = avoidance;
    this.rightOfWay = rightOfWay;
    this.seeing = seeing;
  }

  @Override
  public Class<? extends GoalInformation> goalClass() {
    return Waypoint.class;
  }

  @Override
  public double distanceM(GoalInformation goal, StateInformation state) {
    Point ned = Vehicle.of(state).orElseThrow().nedOf(Place.of((Waypoint) goal));
    return Math.hypot(ned.x(), ned.y());
  }

  @Override
  public void enter(Pursuit pursuit) {
    guidance.begin(lineStart(pursuit));
    avoidance.begin();
    altitude.begin();
    beside.begin();
    attempts = 1;
    armed = pursuit.before().filter(before -> before.uid().equals(pursuit.goal().uid())).isEmpty();
    stayedMicros = OptionalLong.empty();
    reached = false;
    nearestM = Double.POSITIVE_INFINITY;
    last = Optional.empty();
    aimedAt = Optional.empty();
  }

  /** A moved waypoint is reached, passed or missed at its current position. */
  private void follow(Place target) {
    if (aimedAt.filter(before -> !before.equals(target)).isPresent()) {
      guidance.begin(Optional.empty());
      altitude.begin();
      beside.begin();
      attempts = 1;
      armed = true;
      reached = false;
      nearestM = Double.POSITIVE_INFINITY;
      last = Optional.empty();
    }
    aimedAt = Optional.of(target);
  }

  @Override
  public void handOver(HandOver state) {
    state
        .number("ATTEMPTS", attempts)
        .flag("ARMED", armed)
        .flag("REACHED", reached)
        .number("NEAREST", nearestM);
    last.ifPresent(seen -> state.message("LAST STATE", seen));
    aimedAt.ifPresent(place -> place.handOver(state, "AIMED AT"));
    guidance.handOver(state);
  }

  @Override
  public boolean takeOver(HandOver state) {
    if (state.number("ATTEMPTS").isEmpty()) {
      return false;
    }
    guidance.begin(Optional.empty());
    guidance.takeOver(state);
    avoidance.begin();
    attempts = (int) state.number("ATTEMPTS").getAsDouble();
    armed = state.flag("ARMED");
    reached = state.flag("REACHED");
    nearestM = state.number("NEAREST").orElse(Double.POSITIVE_INFINITY);
    last = state.message("LAST STATE", StateInformation.class);
    aimedAt = Place.takenOver(state, "AIMED AT");
    return true;
  }

  /**
   * Position at which a goal is completed; empty for a circle that was left on course for the next
   * goal. A landing or a drop has no altitude there: theirs is that of the ground.
   */
  static Optional<Place> placeOf(Optional<GoalInformation> goal) {
    return goal.filter(Waypoint.class::isInstance)
        .filter(each -> !(each instanceof Station station && station.towardsNext()))
        .map(
            waypoint -> {
              Place place = Place.of((Waypoint) waypoint);
              return isOnGround(waypoint) ? place.withoutAltitude() : place;
            });
  }

  private static boolean isOnGround(GoalInformation goal) {
    return goal instanceof Landing || goal instanceof PayloadDrop;
  }

  /** Where the line to a goal begins: at the goal before, from which the vehicle comes. */
  static Optional<Place> lineStart(Pursuit pursuit) {
    Optional<GoalInformation> before = pursuit.before();
    return before.filter(WaypointState::isOnGround).isEmpty()
        ? placeOf(before)
        : placeOf(before)
            .map(place -> place.orAltitudeOf(Vehicle.of(pursuit.state()).orElseThrow().place()));
  }

  @Override
  public Plan plan(Pursuit pursuit) {
    Waypoint waypoint = (Waypoint) pursuit.goal();
    Place target = Place.of(waypoint);
    follow(target);
    if (avoidance.isHeldUp() && !reached) {
      altitude.begin(); // it waits, and has not missed the waypoint
      beside.begin();
    }
    Vehicle vehicle = Vehicle.of(pursuit.state()).orElseThrow();
    Optional<Order> order = order(waypoint, target, vehicle, pursuit);
    if (order.filter(Order::isNew).isPresent() || yields && order.isEmpty()) {
      guidance.begin(Optional.empty());
      avoidance.begin();
    }
    yields = order.isPresent();
    if (order.isPresent()) {
      return yielding(waypoint, target, vehicle, pursuit, order.get());
    }
    if (avoidance.isOn() && target.isHorizontal()) {
      return around(waypoint, target, vehicle, pursuit);
    }
    NavigationPoint point =
        NavigationPoint.at(
            guidance.towards(
                vehicle, target, aimedAtM(waypoint, pursuit.state()), placeOf(pursuit.after())));
    double toGoM = distanceM(waypoint, pursuit.state());
    speed(waypoint, toGoM, pursuit).ifPresent(point::speed);
    double downM = vehicle.nedOf(target).z();
    look(vehicle, target, waypoint, downM);
    last = Optional.of(pursuit.state());
    List<NavigationPoint> points = List.of(point);
    boolean climbs = isClimbing(waypoint, downM, vehicle);
    if (reached && !climbs && (guidance.isNearest() || !target.isHorizontal())) {
      return new Plan(points, Plan.Progress.COMPLETED, "reached, " + passing(waypoint, downM));
    }
    if (!guidance.hasPassed() || climbs) {
      return Plan.unless(standsBeside(waypoint, downM), points);
    }
    return missed(points, passing(waypoint, downM));
  }

  /** Why a vehicle that can stop gives up a waypoint beside which it stands. */
  private Optional<String> standsBeside(Waypoint waypoint, double downM) {
    if (settings.get().turnAcceleration() > 0.0) {
      beside.begin();
      return Optional.empty();
    }
    double offM = waypoint.verticalThreshold().isPresent() ? Math.abs(downM) : 0.0;
    return beside.step(nowM, offM, waypoint.horizontalThreshold(), time.micros());
  }

  /**
   * Whether a vehicle that can stop is still climbing or descending at a waypoint, also at the very
   * edge of its threshold, where an estimation error could cause a miss. Drifting over the waypoint
   * meanwhile does not count as passing it.
   */
  private boolean isClimbing(Waypoint waypoint, double downM, Vehicle vehicle) {
    boolean comesNearer = altitude.comesNearer(Math.abs(downM), vehicle.timestampMicros());
    return comesNearer
        && settings.get().turnAcceleration() == 0.0
        && nowM <= waypoint.horizontalThreshold()
        && Math.abs(downM)
            > SHARE_NEAR * waypoint.verticalThreshold().orElse(Double.POSITIVE_INFINITY);
  }

  /**
   * Speed of the waypoint, or the speed needed to arrive at its time, within the vehicle's limits.
   * For aircraft it is airspeed, taking the wind into account.
   */
  private OptionalDouble speed(Waypoint waypoint, double toGoM, Pursuit pursuit) {
    if (waypoint.time().isEmpty()) {
      return rightOfWay.speed(waypoint.speed());
    }
    AvoidanceVariables now = seeing.get();
    double most = waypoint.speed().orElse(Math.max(now.maxSpeed(), now.plannedSpeed()));
    double leftS = waypoint.time().getAsDouble() - pursuit.missionS();
    double needed =
        leftS > 0.0
            ? toGoM / leftS - tailWindMps(pursuit.state(), now)
            : most; // already late: as fast as allowed
    return OptionalDouble.of(
        Math.max(Math.max(now.minSpeed(), CREEPS_MPS), Math.min(most, needed)));
  }

  /** Tail wind of a vehicle that cannot stop: ground speed minus airspeed [m/s]. */
  private static double tailWindMps(StateInformation state, AvoidanceVariables now) {
    return now.stops() || state.fluidxDot().isEmpty()
        ? 0.0
        : Vehicle.of(state).orElseThrow().speedMps() - state.fluidxDot().getAsDouble();
  }

  /** Completes a waypoint on its heading; otherwise turns to it in place, or approaches again. */
  private Plan turned(
      Waypoint waypoint, Vehicle vehicle, Place target, Avoidance.Step step, double downM) {
    NavigationPoint point = step.point(vehicle);
    double psi = waypoint.psi().getAsDouble();
    double off = Math.abs(Leg.wrapped(psi - vehicle.headingRad()));
    if (off <= Math.toRadians(seeing.get().arrivalAngle())) {
      String remark =
          String.format(
              Locale.ROOT, "reached, %.0f degrees off its heading, ", Math.toDegrees(off));
      return new Plan(List.of(point), Plan.Progress.COMPLETED, remark + passing(waypoint, downM));
    }
    if (avoidance.turnsOnTheSpot()) {
      double turnRad = Leg.wrapped(psi - vehicle.headingRad());
      if (!detour.hasRoomToTurn(vehicle, last.orElseThrow(), turnRad)) {
        return new Plan(
            List.of(), Plan.Progress.ABANDONED, "given up: no room to turn to its heading");
      }
      Point here = Point.of(0.0, 0.0, downM);
      NavigationPoint turn = NavigationPoint.at(vehicle.body(here)).speed(CREEPS_MPS);
      return Plan.unless(step.givenUp(), List.of(turn.turn(turnRad)));
    }
    Point to = vehicle.nedOf(target);
    boolean isThere = Math.hypot(to.x(), to.y()) <= waypoint.horizontalThreshold();
    if (isThere && step.givenUp().isEmpty()) {
      return Plan.underWay(List.of(point));
    }
    if (attempts >= settings.get().attempts()) {
      return new Plan(
          List.of(point),
          Plan.Progress.ABANDONED,
          "given up: " + attempts + " times there without its heading");
    }
    attempts++;
    reached = false;
    avoidance.begin();
    return new Plan(
        List.of(point), Plan.Progress.UNDER_WAY, "passed without its heading: trying again");
  }

  /** Checks whether other vessels leave the direct way or route to the waypoint free. */
  private Optional<Order> order(Waypoint waypoint, Place target, Vehicle vehicle, Pursuit pursuit) {
    if (!rightOfWay.isOn() || !target.isHorizontal()) {
      return Optional.empty();
    }
    Point way = vehicle.nedOf(target);
    OptionalDouble speed = speed(waypoint, Math.hypot(way.x(), way.y()), pursuit);
    return rightOfWay.order(
        vehicle,
        pursuit.state(),
        waypoint.uid(),
        yields ? way : avoidance.ahead(vehicle).orElse(way),
        speed.orElseThrow());
  }

  /** Follows the course and speed required by right of way. */
  private Plan yielding(
      Waypoint waypoint, Place target, Vehicle vehicle, Pursuit pursuit, Order order) {
    double downM = vehicle.nedOf(target).z();
    look(vehicle, target, waypoint, downM);
    last = Optional.of(pursuit.state());
    Place place = order.place().orAltitudeOf(target);
    OptionalDouble speed = OptionalDouble.of(order.speedMps());
    NavigationPoint point;
    if (order.speedMps() == 0.0) {
      point = NavigationPoint.at(Point.of(1.0, 0.0, 0.0)).speed(0.0);
    } else if (avoidance.isOn()) {
      Avoidance.Wanted wanted =
          new Avoidance.Wanted(
              waypoint.uid(), place, waypoint.horizontalThreshold(), OptionalDouble.empty(), speed);
      Avoidance.Step step = avoidance.step(vehicle, pursuit.state(), wanted);
      step.givenUp().ifPresent(why -> avoidance.begin());
      point = step.point(vehicle);
    } else {
      double threshold = waypoint.horizontalThreshold();
      point =
          NavigationPoint.at(guidance.towards(vehicle, place, threshold, Optional.empty()))
              .speed(order.speedMps());
    }
    return reached && waypoint.psi().isEmpty() && isNearEnough(waypoint, pursuit.state())
        ? new Plan(List.of(point), Plan.Progress.COMPLETED, "reached, " + passing(waypoint, downM))
        : Plan.underWay(List.of(point));
  }

  /** Plans the next step on a route around obstacles. */
  private Plan around(Waypoint waypoint, Place target, Vehicle vehicle, Pursuit pursuit) {
    Avoidance.Step step =
        avoidance.step(
            vehicle,
            pursuit.state(),
            new Avoidance.Wanted(
                waypoint.uid(),
                target,
                waypoint.horizontalThreshold(),
                waypoint.psi(),
                speed(
                    waypoint,
                    avoidance.remainingM().orElse(distanceM(waypoint, pursuit.state())),
                    pursuit)));
    double downM = vehicle.nedOf(target).z();
    look(vehicle, target, waypoint, downM);
    last = Optional.of(pursuit.state());
    NavigationPoint point = step.point(vehicle);
    if (reached && waypoint.psi().isPresent()) {
      return turned(waypoint, vehicle, target, step, downM);
    }
    List<NavigationPoint> points = List.of(point);
    boolean climbs = isClimbing(waypoint, downM, vehicle);
    if (reached && !climbs && isNearEnough(waypoint, pursuit.state())) {
      avoidance.reached(vehicle, pursuit.state());
      return new Plan(points, Plan.Progress.COMPLETED, "reached, " + passing(waypoint, downM));
    }
    return Plan.unless(step.givenUp(), points);
  }

  /**
   * Threshold to aim at: vehicles that turn in place leave a waypoint at the edge of its threshold,
   * where an estimation error could cause a miss. Corner-cutting turns keep a margin anyway.
   */
  private double aimedAtM(Waypoint waypoint, StateInformation state) {
    return settings.get().turnAcceleration() == 0.0
        ? WaypointAccuracy.surelyWithinM(waypoint.horizontalThreshold(), state)
        : waypoint.horizontalThreshold();
  }

  /**
   * Whether a waypoint within its threshold may be left: within the corner-cutting limit, or at the
   * closest approach. At the very edge, an estimation error could cause a miss.
   */
  private boolean isNearEnough(Waypoint waypoint, StateInformation state) {
    double nearM = settings.get().lines().turns().nearM(aimedAtM(waypoint, state));
    if (!avoidance.turnsOnTheSpot()) { // its routes end closer
      nearM = Math.min(nearM, SHARE_NEAR * waypoint.horizontalThreshold());
    }
    return nowM <= nearM || nowM > nearestM;
  }

  /** Updates the closest distance since the last state. */
  private void look(Vehicle vehicle, Place target, Waypoint waypoint, double downM) {
    Point to = vehicle.nedOf(target);
    Point from =
        last.filter(before -> isRecent(before, vehicle))
            .flatMap(Vehicle::of)
            .map(before -> vehicle.nedOf(before.place()))
            .orElse(Point.ORIGIN);
    double distance = new Leg(from.x(), from.y(), 0.0, 0.0).distanceM(to.x(), to.y());
    boolean within = distance <= waypoint.horizontalThreshold();
    nearestM = guidance.isApproaching() ? Math.min(nearestM, distance) : distance;
    nowM = Math.hypot(to.x(), to.y());
    if (!armed) {
      armed = nowM > waypoint.horizontalThreshold() || hasStayed(vehicle);
    } else if (within) {
      reached |= Math.abs(downM) <= waypoint.verticalThreshold().orElse(Double.POSITIVE_INFINITY);
    }
  }

  /** An aircraft leaves anyway; a vehicle that can stop has no reason to. */
  private boolean hasStayed(Vehicle vehicle) {
    long now = vehicle.timestampMicros();
    stayedMicros = OptionalLong.of(stayedMicros.orElse(now));
    boolean leaves =
        avoidance.isOn() ? !seeing.get().stops() : settings.get().turnAcceleration() > 0.0;
    return !leaves && now - stayedMicros.getAsLong() >= STAYS_MICROS;
  }

  private static boolean isRecent(StateInformation before, Vehicle vehicle) {
    long step = vehicle.timestampMicros() - before.timestamp().orElse(0L);
    return step > 0 && step <= LONGEST_STEP_MICROS;
  }

  private Plan missed(List<NavigationPoint> points, String passing) {
    int attemptsAllowed = settings.get().attempts();
    String remark = "missed, " + passing + ", attempt " + attempts + " of " + attemptsAllowed;
    if (attempts >= attemptsAllowed) {
      return new Plan(points, Plan.Progress.ABANDONED, remark + ": given up");
    }
    attempts++;
    nearestM = Double.POSITIVE_INFINITY;
    guidance.begin(Optional.empty());
    return new Plan(points, Plan.Progress.UNDER_WAY, remark + ": turning round for another");
  }

  private String passing(Waypoint waypoint, double downM) {
    return String.format(
        Locale.ROOT,
        "passed at %.1f m (threshold %.1f m), %.1f m %s%s",
        nearestM,
        waypoint.horizontalThreshold(),
        Math.abs(downM),
        downM > 0.0 ? "high" : "low",
        waypoint.verticalThreshold().isPresent()
            ? String.format(
                Locale.ROOT, " (threshold %.1f m)", waypoint.verticalThreshold().getAsDouble())
            : "");
  }
}
