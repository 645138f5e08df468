package org.u2sa.planning;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Station;
import org.u2sa.planning.avoidance.Avoidance;
import org.u2sa.planning.goals.PursuitTime;
import org.u2sa.planning.guidance.Leg;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.guidance.WaypointGuidance;
import org.u2sa.planning.station.BerthWay;
import org.u2sa.planning.station.StationHeading;
import org.u2sa.planning.station.StationPatience;
import org.u2sa.planning.station.StationVariables;
import org.u2sa.planning.station.StationWait;
import org.u2sa.service.handover.HandOver;

/**
 * Keeps the vehicle at a {@link Station}, circling if it has a LOITER RADIUS. Without one, the
 * vehicle moves to the position, or to the start of its straight way and along it, and stays until
 * the time has elapsed. With a route planner it goes around what is in the way; only along the
 * straight way it trusts the mission. The time restarts when the vehicle leaves a threshold or the
 * heading.
 */
final class StationState implements PlannerState {
  private enum Phase {
    /** Moving to the station, or to the start of the straight way. */
    TRANSIT,
    /** Moving along the straight way. */
    BERTHING,
    /** At the station. */
    THERE
  }

  private static final double INSIDE = 0.7; // share of the threshold
  private static final double INSIDE_STEP = 0.05;

  private final WaypointGuidance guidance;
  private final Supplier<StationVariables> settings;
  private final StationCircle circle;
  private Optional<Place> here = Optional.empty(); // start, for stations without position
  private Phase phase = Phase.TRANSIT;
  private long sinceMicros = Long.MIN_VALUE; // since when it is on station
  private final StationHeading heading = new StationHeading();
  private final BerthWay way = new BerthWay(heading);
  private final BooleanSupplier lacksSway;
  private final PursuitTime time;
  private final StationPatience patience = new StationPatience();
  private final Detour detour;
  private boolean isRouted; // follows the route planner
  private final StationWait wait = new StationWait();

  /**
   * Creates the state.
   *
   * @param detour way around obstacles
   * @param lacksSway whether the vehicle is known to have no sideways thrust
   * @param time time against which patience with a station is measured
   */
  StationState(
      WaypointGuidance guidance,
      Supplier<StationVariables> settings,
      StationCircle circle,
      Detour detour,
      BooleanSupplier lacksSway,
      PursuitTime time) {
    this.guidance = guidance;
    this.settings = settings;
    this.circle = circle;
    this.detour = detour;
    this.lacksSway = lacksSway;
    this.time = time;
  }

  @Override
  public Class<? extends GoalInformation> goalClass() {
    return Station.class;
  }

  @Override
  public double distanceM(GoalInformation goal, StateInformation state) {
    Place place = Place.of((Station) goal);
    return place.isHorizontal()
        ? length(Vehicle.of(state).orElseThrow().nedOf(place))
        : 0.0; // it is at its starting position
  }

  @Override
  public void enter(Pursuit pursuit) {
    guidance.begin(WaypointState.lineStart(pursuit));
    phase = Phase.TRANSIT;
    sinceMicros = Long.MIN_VALUE;
    here = Vehicle.of(pursuit.state()).map(Vehicle::place);
    circle.leave();
    isRouted = false;
    wait.begin();
    heading.begin(lacksSway.getAsBoolean());
    patience.begin(0.0);
  }

  /** Position of a station, or the starting position if it has none. */
  private Place place(Station station) {
    Place place = Place.of(station);
    if (place.isHorizontal() || here.isEmpty()) {
      return place;
    }
    return place.upM().isPresent() ? here.get().at(place.upM().getAsDouble()) : here.get();
  }

  @Override
  public void handOver(HandOver state) {
    state.text("STATION PHASE", phase.name());
    here.ifPresent(place -> place.handOver(state, "STATION BEGAN"));
    if (circle.isCircling()) {
      circle.handOver(state, "CIRCLE");
      return;
    }
    if (sinceMicros != Long.MIN_VALUE) {
      state.number("STATION SINCE", Clock.seconds(sinceMicros));
    }
    guidance.handOver(state);
    heading.handOver(state);
    state.number("STATION NEAR", patience.nearS());
  }

  @Override
  public boolean takeOver(HandOver state) {
    if (state.text("STATION PHASE").isEmpty()) {
      return false;
    }
    guidance.begin(Optional.empty());
    guidance.takeOver(state);
    here = Place.takenOver(state, "STATION BEGAN");
    circle.takeOver(state, "CIRCLE");
    heading.takeOver(state);
    way.begin();
    patience.begin(state.number("STATION NEAR").orElse(0.0));
    phase = Phase.valueOf(state.text("STATION PHASE").get());
    OptionalDouble since = state.number("STATION SINCE");
    sinceMicros = since.isPresent() ? Clock.micros(since.getAsDouble()) : Long.MIN_VALUE;
    return true;
  }

  @Override
  public Plan plan(Pursuit pursuit) {
    Station station = (Station) pursuit.goal();
    Vehicle vehicle = Vehicle.of(pursuit.state()).orElseThrow();
    Place place = place(station);
    if (circle.isCircling()) {
      Place centre = place.orAltitudeOf(here.orElse(place));
      return circle.plan(station, pursuit.state(), vehicle, centre, pursuit.after());
    }
    if (station.turns().isPresent()) {
      return new Plan(List.of(), Plan.Progress.ABANDONED, "given up: turns need a LOITER RADIUS");
    }
    Point to = vehicle.nedOf(place);
    boolean isBerth = station.approach().isPresent() && station.psi().isPresent();
    Point start = isBerth ? to.plus(entrance(station)) : to;
    if (phase == Phase.TRANSIT && isAt(start, isBerth, station, vehicle)) {
      phase = isBerth ? Phase.BERTHING : Phase.THERE;
      way.begin();
    }
    Leg leg = new Leg(start.x(), start.y(), to.x(), to.y());
    if (phase == Phase.BERTHING && length(to) <= station.horizontalThreshold()) {
      phase = Phase.THERE;
    } else if (phase == Phase.BERTHING && way.hasLeft(leg, settings.get())) {
      phase = Phase.TRANSIT;
    }
    boolean isNear = phase != Phase.TRANSIT || length(start) <= settings.get().stationTurnWithin();
    patience.count(isNear, time.micros());
    Avoidance.Wanted wanted = wanted(station, place, isBerth && phase == Phase.TRANSIT);
    boolean isOnStraightWay = isBerth && phase != Phase.TRANSIT;
    if (!isOnStraightWay && goesAround(vehicle, pursuit.state(), wanted)) {
      Plan step = detour.step(vehicle, pursuit.state(), wanted);
      step.points().forEach(each -> detour.stopAt(each, vehicle, pursuit.state(), wanted));
      return step.progress() == Plan.Progress.UNDER_WAY
          ? progress(station, vehicle, to, step.points())
          : step;
    }
    NavigationPoint point;
    boolean stays =
        isOnStraightWay
            ? detour.isBlockedSoon(vehicle, pursuit.state(), place)
            : mustStay(vehicle, pursuit.state(), wanted);
    Optional<Place> inside =
        stays && !isOnStraightWay ? inside(vehicle, pursuit.state(), wanted) : Optional.empty();
    if (inside.isPresent()) {
      point = NavigationPoint.at(vehicle.body(vehicle.nedOf(inside.get())));
      slow(point, vehicle, pursuit.state(), to(inside.get(), wanted), false);
    } else if (stays) {
      point = towards(Point.ORIGIN, Optional.empty(), station, vehicle, true).speed(0.0);
    } else if (phase == Phase.BERTHING) {
      point = way.point(leg, to.z(), turn(station, vehicle), station, vehicle, settings.get());
      slow(point, vehicle, pursuit.state(), berth(station, place), true);
    } else {
      Point target = phase == Phase.TRANSIT ? start : to;
      Optional<Place> line = isBerth ? Optional.empty() : Optional.of(place);
      boolean mayTurn = isBerth || mayTurn(station, vehicle, pursuit.state(), wanted);
      point = towards(target, line, station, vehicle, mayTurn);
      Avoidance.Wanted end = isOnStraightWay ? berth(station, place) : wanted;
      slow(point, vehicle, pursuit.state(), end, isOnStraightWay);
      if (isOnStraightWay && station.backwards()) {
        point.backwards(point.point().x() < 0.0); // there is no room to turn round
      }
    }
    boolean hasRoom =
        point.turn().isEmpty()
            || detour.hasRoomToTurn(vehicle, pursuit.state(), point.turn().getAsDouble());
    if (!hasRoom) {
      point = NavigationPoint.at(Point.ORIGIN).speed(0.0);
    }
    String remark = wait.remark(stays || !hasRoom, vehicle.timestampMicros());
    Plan plan = progress(station, vehicle, to, List.of(point));
    return plan.progress() == Plan.Progress.UNDER_WAY
        ? new Plan(plan.points(), Plan.Progress.UNDER_WAY, remark)
        : plan;
  }

  /**
   * Whether the route planner leads: near the station, and for vehicles that look above and below
   * themselves also far from it, only around something. Far from it, those keep to the route then:
   * the line to the station, which they have left, may lead back to what they went around.
   */
  private boolean goesAround(Vehicle vehicle, StateInformation state, Avoidance.Wanted wanted) {
    double toGoM = length(vehicle.nedOf(wanted.target()));
    boolean isFar = toGoM > Math.max(settings.get().stationTurnWithin(), wanted.thresholdM());
    boolean routes =
        detour.isOfAircraftThatStops(state)
            ? toGoM > wanted.thresholdM()
                && (isFar && isRouted || detour.isBlocked(vehicle, state, wanted.target()))
            : detour.isPossible()
                && toGoM > wanted.thresholdM()
                && (isFar
                    || detour.isHindered(vehicle, state, wanted.target())
                    || detour.isOccupied(vehicle, state, wanted.target()));
    if (routes && !isRouted) {
      detour.begin();
    }
    isRouted = routes;
    return routes;
  }

  /**
   * Whether a vehicle within the threshold stays where it is, because something stands or moves at
   * the place itself.
   */
  private boolean mustStay(Vehicle vehicle, StateInformation state, Avoidance.Wanted wanted) {
    Place place = wanted.target();
    return !detour.isOfAircraftThatStops(state)
        && length(vehicle.nedOf(place)) <= wanted.thresholdM()
        && detour.isOccupied(vehicle, state, place);
  }

  /**
   * Where a vehicle at the edge of the threshold goes, because any drift would lead it outside;
   * empty if it is well inside, or something is there or on the way.
   */
  private Optional<Place> inside(Vehicle vehicle, StateInformation state, Avoidance.Wanted wanted) {
    Point toGo = vehicle.nedOf(wanted.target());
    for (double share = INSIDE; share * wanted.thresholdM() < length(toGo); share += INSIDE_STEP) {
      double by = -share * wanted.thresholdM() / length(toGo);
      Place place = wanted.target().moved(by * toGo.x(), by * toGo.y());
      if (!detour.isOccupied(vehicle, state, place)) {
        return Optional.of(place);
      }
    }
    return Optional.empty();
  }

  /** Where it goes: to the station, or to the start of its straight way. */
  private Avoidance.Wanted wanted(Station station, Place place, boolean toEntrance) {
    Point entrance = toEntrance ? entrance(station) : Point.ORIGIN;
    return new Avoidance.Wanted(
        station.uid(),
        toEntrance ? place.moved(entrance.x(), entrance.y()) : place,
        within(toEntrance, station),
        OptionalDouble.empty(),
        toEntrance ? OptionalDouble.empty() : station.speed());
  }

  /** The berth itself, at the speed of its straight way. */
  private Avoidance.Wanted berth(Station station, Place place) {
    double speed = station.speed().orElse(settings.get().berthSpeed());
    return new Avoidance.Wanted(
        station.uid(),
        place,
        station.horizontalThreshold(),
        OptionalDouble.empty(),
        OptionalDouble.of(speed));
  }

  private static Avoidance.Wanted to(Place place, Avoidance.Wanted wanted) {
    return new Avoidance.Wanted(
        wanted.goal(), place, wanted.thresholdM(), wanted.headingRad(), wanted.speedMps());
  }

  /** Sets the speed at which it moves to a place and stops there. */
  private void slow(
      NavigationPoint point,
      Vehicle vehicle,
      StateInformation state,
      Avoidance.Wanted end,
      boolean berths) {
    detour.straightMps(vehicle, state, end, berths).ifPresent(point::speed);
  }

  /** From the station to the start of its straight way: north, east [m]. */
  private static Point entrance(Station station) {
    double sign = station.backwards() ? 1.0 : -1.0;
    double length = sign * station.approach().getAsDouble();
    double psi = station.psi().getAsDouble();
    return Point.of(length * Math.cos(psi), length * Math.sin(psi), 0.0);
  }

  private boolean isAt(Point start, boolean isBerth, Station station, Vehicle vehicle) {
    return length(start) <= within(isBerth, station) && (!isBerth || isOnHeading(station, vehicle));
  }

  /** Tolerance at the station, or at the start of its straight way [m]. */
  private double within(boolean isStart, Station station) {
    return isStart ? settings.get().berthAccuracy() : station.horizontalThreshold();
  }

  private boolean isOnHeading(Station station, Vehicle vehicle) {
    return station.psi().isEmpty()
        || Math.abs(turn(station, vehicle)) <= Math.toRadians(settings.get().stationAngle());
  }

  private static double turn(Station station, Vehicle vehicle) {
    return Leg.wrapped(station.psi().getAsDouble() - vehicle.headingRad());
  }

  /** Whether it turns to the station's heading already on the way there. */
  private boolean mayTurn(
      Station station, Vehicle vehicle, StateInformation state, Avoidance.Wanted wanted) {
    return station.psi().isEmpty()
        || length(vehicle.nedOf(wanted.target())) <= wanted.thresholdM()
        || detour.hasRoomToTurnOnWay(vehicle, state, wanted.target(), turn(station, vehicle));
  }

  /** Moves to a point; from a distance along a line, if the point is the station itself. */
  private NavigationPoint towards(
      Point ned, Optional<Place> place, Station station, Vehicle vehicle, boolean mayTurn) {
    boolean isNear = length(ned) <= settings.get().stationTurnWithin();
    Point body =
        isNear || place.isEmpty()
            ? vehicle.body(ned)
            : guidance.towards(
                vehicle, place.get(), station.horizontalThreshold(), Optional.empty());
    NavigationPoint point = NavigationPoint.at(body);
    if (isNear && mayTurn && station.psi().isPresent()) {
      boolean isStart = place.isEmpty() && phase == Phase.TRANSIT;
      double within = within(isStart, station);
      heading.turnRad(ned, turn(station, vehicle), within, vehicle).ifPresent(point::turn);
    }
    return point;
  }

  private Plan progress(Station station, Vehicle vehicle, Point to, List<NavigationPoint> points) {
    long now = vehicle.timestampMicros();
    boolean isThere =
        phase == Phase.THERE
            && length(to) <= station.horizontalThreshold()
            && Math.abs(to.z()) <= station.verticalThreshold().orElse(Double.POSITIVE_INFINITY)
            && isOnHeading(station, vehicle);
    if (!isThere) {
      sinceMicros = Long.MIN_VALUE;
      Optional<String> reason = patience.end(station, settings.get());
      return reason.isPresent()
          ? new Plan(points, Plan.Progress.ABANDONED, reason.get() + off(station, vehicle, to))
          : Plan.underWay(points);
    }
    if (sinceMicros == Long.MIN_VALUE) {
      sinceMicros = now;
    }
    double keptS = Clock.seconds(now - sinceMicros);
    if (keptS < station.duration().orElse(Double.MAX_VALUE)) {
      return Plan.underWay(points);
    }
    String remark = String.format(Locale.ROOT, "kept for %.1f s", keptS);
    return new Plan(points, Plan.Progress.COMPLETED, remark);
  }

  private static String off(Station station, Vehicle vehicle, Point to) {
    String where = String.format(Locale.ROOT, "; now %.1f m from it", length(to));
    if (station.psi().isEmpty()) {
      return where;
    }
    double offDeg = Math.toDegrees(Math.abs(turn(station, vehicle)));
    return where + String.format(Locale.ROOT, " and %.0f deg off its heading", offDeg);
  }

  private static double length(Point ned) {
    return Math.hypot(ned.x(), ned.y());
  }
}
