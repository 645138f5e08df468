package org.u2sa.planning;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Station;
import org.u2sa.planning.guidance.Leg;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.guidance.WaypointGuidance;
import org.u2sa.service.handover.HandOver;

/**
 * Keeps the vehicle at a {@link Station}, circling if it has a LOITER RADIUS. Without one, the
 * vehicle moves to the position, or to the start of its straight way and along it, and stays until
 * the time has elapsed. The time restarts when the vehicle leaves a threshold or the heading.
 */
final class StationState implements PlannerState {
  /** Configuration variables of stations and berths. */
  record Variables(
      @Variable(unit = "m", min = 0, max = 1000, ifAbsent = 5)
          @Description(
              "Distance from a station at which the vehicle turns to its required heading.")
          double stationTurnWithin,
      @Variable(unit = "deg", min = 0.1, max = 180, ifAbsent = 5)
          @Description(
              "Heading error up to which a vehicle counts as being on a station's heading.")
          double stationAngle,
      @Variable(unit = "m", min = 0.01, max = 100, ifAbsent = 0.3)
          @Description(
              "Tolerance at the start of the straight way to a berth, and cross-track error at which the vehicle waits until it is back on the way's line.")
          double berthAccuracy,
      @Variable(unit = "m/s", min = 0.01, max = 10, ifAbsent = 0.3)
          @Description("Speed on the straight way to a berth that does not specify one.")
          double berthSpeed,
      @Variable(unit = "m", min = 0.01, max = 100, ifAbsent = 1)
          @Description("Look-ahead distance on the straight way to a berth.")
          double berthLookAhead) {}

  private enum Phase {
    /** Moving to the station, or to the start of the straight way. */
    TRANSIT,
    /** Moving along the straight way. */
    BERTHING,
    /** At the station. */
    THERE
  }

  private final WaypointGuidance guidance;
  private final Supplier<Variables> settings;
  private final StationCircle circle;
  private Optional<Place> here = Optional.empty(); // start, for stations without position
  private Phase phase = Phase.TRANSIT;
  private long sinceMicros = Long.MIN_VALUE; // since when it is on station

  StationState(WaypointGuidance guidance, Supplier<Variables> settings, StationCircle circle) {
    this.guidance = guidance;
    this.settings = settings;
    this.circle = circle;
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
    guidance.begin(WaypointState.placeOf(pursuit.before()));
    phase = Phase.TRANSIT;
    sinceMicros = Long.MIN_VALUE;
    here = Vehicle.of(pursuit.state()).map(Vehicle::place);
    circle.leave();
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
      circle.handOver(state);
      return;
    }
    if (sinceMicros != Long.MIN_VALUE) {
      state.number("STATION SINCE", Clock.seconds(sinceMicros));
    }
    guidance.handOver(state);
  }

  @Override
  public boolean takeOver(HandOver state) {
    if (state.text("STATION PHASE").isEmpty()) {
      return false;
    }
    guidance.begin(Optional.empty());
    guidance.takeOver(state);
    here = Place.takenOver(state, "STATION BEGAN");
    circle.takeOver(state);
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
    }
    if (phase == Phase.BERTHING && length(to) <= station.horizontalThreshold()) {
      phase = Phase.THERE;
    }
    NavigationPoint point;
    if (phase == Phase.BERTHING) {
      point = along(start, to, station, vehicle);
    } else {
      Point target = phase == Phase.TRANSIT ? start : to;
      point = towards(target, isBerth ? Optional.empty() : Optional.of(place), station, vehicle);
    }
    return progress(station, vehicle, to, List.of(point));
  }

  /** From the station to the start of its straight way: north, east [m]. */
  private static Point entrance(Station station) {
    double sign = station.backwards() ? 1.0 : -1.0;
    double length = sign * station.approach().getAsDouble();
    double psi = station.psi().getAsDouble();
    return Point.of(length * Math.cos(psi), length * Math.sin(psi), 0.0);
  }

  private boolean isAt(Point start, boolean isBerth, Station station, Vehicle vehicle) {
    double within = isBerth ? settings.get().berthAccuracy() : station.horizontalThreshold();
    return length(start) <= within && (!isBerth || isOnHeading(station, vehicle));
  }

  private boolean isOnHeading(Station station, Vehicle vehicle) {
    return station.psi().isEmpty()
        || Math.abs(turn(station, vehicle)) <= Math.toRadians(settings.get().stationAngle());
  }

  private static double turn(Station station, Vehicle vehicle) {
    return Leg.wrapped(station.psi().getAsDouble() - vehicle.headingRad());
  }

  /** Moves to a point; from a distance along a line, if the point is the station itself. */
  private NavigationPoint towards(
      Point ned, Optional<Place> place, Station station, Vehicle vehicle) {
    boolean isNear = length(ned) <= settings.get().stationTurnWithin();
    Point body =
        isNear || place.isEmpty()
            ? vehicle.body(ned)
            : guidance.towards(
                vehicle, place.get(), station.horizontalThreshold(), Optional.empty());
    NavigationPoint point = NavigationPoint.at(body);
    if (phase == Phase.TRANSIT && station.approach().isEmpty()) {
      station.speed().ifPresent(point::speed);
    }
    if (isNear && station.psi().isPresent()) {
      point.turn(turn(station, vehicle));
    }
    return point;
  }

  /**
   * Target on the straight way: a point ahead on its line, or beside the vehicle while it is off
   * the line.
   */
  private NavigationPoint along(Point start, Point to, Station station, Vehicle vehicle) {
    Variables now = settings.get();
    Leg leg = new Leg(start.x(), start.y(), to.x(), to.y());
    boolean isOff = Math.abs(leg.acrossM(0.0, 0.0)) > now.berthAccuracy();
    double ahead = leg.alongM(0.0, 0.0) + (isOff ? 0.0 : now.berthLookAhead());
    double along = Math.min(leg.lengthM(), ahead);
    Point ned = Point.of(leg.northAtM(along), leg.eastAtM(along), to.z());
    return NavigationPoint.at(vehicle.body(ned))
        .speed(station.speed().orElse(now.berthSpeed()))
        .backwards(station.backwards())
        .turn(turn(station, vehicle));
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
      return Plan.underWay(points);
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

  private static double length(Point ned) {
    return Math.hypot(ned.x(), ned.y());
  }
}
