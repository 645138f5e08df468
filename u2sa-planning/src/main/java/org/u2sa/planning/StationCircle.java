package org.u2sa.planning;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.DoubleSupplier;
import java.util.function.Supplier;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.planning.avoidance.Avoidance;
import org.u2sa.planning.flight.FlightVariables;
import org.u2sa.planning.guidance.Leg;
import org.u2sa.planning.guidance.LineSettings;
import org.u2sa.planning.guidance.LoiterCircle;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.service.handover.HandOver;

/**
 * A {@link Station} of a vehicle that cannot stop: a circle around it. Duration and turns count
 * from the arrival on the circle at the altitude of the station, even if the vehicle has to evade
 * later. Where the circle is obstructed, the vehicle goes around to a later part of it. A vehicle
 * that holds circles likewise, without end.
 */
final class StationCircle {
  private static final double LOOKS_AHEAD_RAD =
      1.2; // distance along the circle to check for obstructions
  private static final double NEXT_ENTRY_RAD = Math.toRadians(60.0);
  private static final int ENTRIES = 5;
  private static final double AWAY = 0.5; // in radii: not at an entry
  private static final double AT = 0.25; // at it
  private static final double UNREACHABLE_S = 4.0; // time without a route to an entry
  private static final double ALONG_RAD = Math.toRadians(45.0); // maximum course error
  private static final double SLACK = 0.05; // of the radius
  private static final double WIDENS_PER_S = 0.2; // of the distance from the circle
  private static final double MAX_WIDER = 1.0; // of the radius
  private static final double LONGEST_STEP_S = 1.0;
  private static final double LEAVES_RAD = Math.toRadians(12.0); // lead to the next goal's course

  private static final String HOLD = "hold"; // UID of the station

  /** A longer part of a circle is not flown around: there may be no room to turn away. */
  private static final int MAX_HIGH_GROUND_DEG = 60;

  private final Detour detour;
  private final Supplier<LineSettings> lines;
  private final Supplier<Double> radiusM; // default for stations without a radius
  private final Supplier<FlightVariables> settings;
  private final boolean endless;
  private final DoubleSupplier giveUpAfterS; // without coming farther along the circle; 0: never
  private LoiterCircle circle; // null before the first plan
  private Optional<Place> place = Optional.empty(); // its centre as given by the station
  private double givenM; // its radius as given by the station; 0: none
  private int
      entry; // number of the current detour's entry, from 1; 0: on the circle or straight to it
  private double entryRad; // the entry's direction from the centre
  private boolean hasLeft; // has been away from the entry since it was chosen
  private long lostSince; // since when there is no route; MAX_VALUE with one
  private long sinceMicros; // since when it counts; MIN_VALUE before
  private double turnedRad;
  private double farthestRad; // that it has turned
  private long farthestMicros; // when it had
  private double widerM; // distance of the point ahead outside the circle
  private long widenedMicros;
  private double bearingRad;

  /**
   * @param endless whether it cannot be given up, because the vehicle holds there
   */
  StationCircle(
      Detour detour,
      Supplier<LineSettings> lines,
      Supplier<Double> radius,
      Supplier<FlightVariables> settings,
      DoubleSupplier giveUpAfterS,
      boolean endless) {
    this.detour = detour;
    this.lines = lines;
    this.radiusM = radius;
    this.settings = settings;
    this.giveUpAfterS = giveUpAfterS;
    this.endless = endless;
  }

  /** Whether the vehicle circles rather than stays. */
  boolean isCircling() {
    return radiusM.get() > 0.0;
  }

  /** Discards the circle because another goal is pursued. */
  void leave() {
    circle = null;
    place = Optional.empty();
  }

  /** The next step of a vehicle that holds on the circle about a place. */
  List<NavigationPoint> hold(Place centre, StateInformation state, Vehicle vehicle) {
    Plan plan =
        plan(new Station().uid(HOLD), state, vehicle, centre, Optional.<GoalInformation>empty());
    return plan.points();
  }

  private void begin(Station station, Place centre, Vehicle vehicle) {
    givenM = station.radius().orElse(0.0);
    circle =
        givenM == 0.0
            ? new LoiterCircle(centre, radiusM.get(), vehicle)
            : LoiterCircle.signed(centre, givenM);
    sinceMicros = Long.MIN_VALUE;
    turnedRad = 0.0;
    farthestRad = Double.NEGATIVE_INFINITY;
    widerM = 0.0;
    entry = 0;
    detour.begin();
  }

  /** Saves the circle under a name: a vehicle may hold on another one than that of its goal. */
  void handOver(HandOver state, String name) {
    if (circle == null) {
      return;
    }
    circle.handOver(state, name);
    place.ifPresent(centre -> centre.handOver(state, name + " CENTRE"));
    state
        .number(name + " GIVEN", givenM)
        .number(name + " TURNED", turnedRad)
        .number(name + " WIDER", widerM);
    if (sinceMicros != Long.MIN_VALUE) {
      state.number(name + " SINCE", Clock.seconds(sinceMicros));
    }
  }

  /** Continues the circle saved under a name. */
  void takeOver(HandOver state, String name) {
    place = Place.takenOver(state, name + " CENTRE");
    circle = LoiterCircle.takenOver(state, name).orElse(null);
    givenM = state.number(name + " GIVEN").orElse(0.0);
    turnedRad = state.number(name + " TURNED").orElse(0.0);
    widerM = state.number(name + " WIDER").orElse(0.0);
    OptionalDouble since = state.number(name + " SINCE");
    sinceMicros = since.isPresent() ? Clock.micros(since.getAsDouble()) : Long.MIN_VALUE;
    farthestRad = Double.NEGATIVE_INFINITY;
    bearingRad = Double.NaN;
    entry = 0;
    detour.begin();
  }

  /**
   * Plans the next step.
   *
   * @param after the next goal
   * @param centre of the circle, with altitude; a changed centre or radius starts a new circle
   */
  Plan plan(
      Station station,
      StateInformation state,
      Vehicle vehicle,
      Place centre,
      Optional<GoalInformation> after) {
    boolean isChanged =
        !place.equals(Optional.of(centre)) || givenM != station.radius().orElse(0.0);
    if (circle == null || isChanged) {
      place = Optional.of(centre);
      begin(station, centre, vehicle);
    }
    count(station, vehicle);
    widen(vehicle);
    NavigationPoint point =
        NavigationPoint.at(
            vehicle.body(
                circle.tangentAhead(vehicle, lines.get().lookAheadM(vehicle.speedMps()), widerM)));
    station.speed().ifPresent(point::speed);
    if (isOver(station, vehicle) && mayLeave(station, vehicle, after)) {
      return new Plan(List.of(point), Plan.Progress.COMPLETED, counted(vehicle));
    }
    if (!detour.isPossible()) {
      return Plan.underWay(List.of(point));
    }
    boolean isNew = sinceMicros == Long.MIN_VALUE && !endless;
    long highDeg =
        isNew ? circle.closedDeg(at -> detour.isGroundAt(vehicle, state, at, centre)) : 0;
    if (highDeg > MAX_HIGH_GROUND_DEG) {
      String why = "given up: the ground is too high along " + highDeg + " degrees of the circle";
      return new Plan(List.of(point), Plan.Progress.ABANDONED, why);
    }
    double idleS = Clock.seconds(vehicle.timestampMicros() - farthestMicros);
    boolean isPatient = endless || giveUpAfterS.getAsDouble() == 0.0;
    if (entry > 0 && !isPatient && idleS > giveUpAfterS.getAsDouble()) {
      String why = String.format(Locale.ROOT, "given up: no farther along it for %.0f s", idleS);
      return new Plan(List.of(point), Plan.Progress.ABANDONED, why);
    }
    boolean isFree = !isHindered(vehicle, state);
    if (entry > 0 && isFree && isAlong(vehicle)) {
      entry = 0;
    } else if (!isFree && (entry == 0 || isAtEntry(vehicle))) {
      enter(1, vehicle);
    }
    return entry == 0 ? Plan.underWay(List.of(point)) : around(station, state, vehicle, point);
  }

  /** Whether the way to the circle or along it is obstructed. */
  private boolean isHindered(Vehicle vehicle, StateInformation state) {
    double away = circle.outsideM(vehicle) + circle.radiusM();
    double tangent = away > circle.radiusM() ? Math.acos(circle.radiusM() / away) : 0.0;
    double ahead = circle.sense() * Math.max(tangent, LOOKS_AHEAD_RAD);
    return detour.isHindered(vehicle, state, circle.at(circle.bearingRad(vehicle) + ahead));
  }

  private boolean isAlong(Vehicle vehicle) {
    double course = circle.courseRad(circle.bearingRad(vehicle));
    return Math.abs(circle.outsideM(vehicle)) < settings.get().approachAccuracy()
        && Math.abs(Leg.wrapped(vehicle.courseRad() - course)) < ALONG_RAD;
  }

  /** Whether it has come to the entry: if the circle is obstructed there, a later one is next. */
  private boolean isAtEntry(Vehicle vehicle) {
    Point to = vehicle.nedOf(circle.at(entryRad));
    double toGoM = Math.hypot(to.x(), to.y());
    hasLeft |= toGoM > AWAY * circle.radiusM();
    double nearM = Math.max(settings.get().approachAccuracy(), AT * circle.radiusM());
    double beyond = circle.sense() * Leg.wrapped(circle.bearingRad(vehicle) - entryRad);
    return hasLeft && toGoM < nearM && beyond >= 0.0;
  }

  private void enter(int number, Vehicle vehicle) {
    entry = number;
    hasLeft = false;
    entryRad = circle.bearingRad(vehicle) + circle.sense() * (1 + number) * NEXT_ENTRY_RAD;
    lostSince = Long.MAX_VALUE;
    detour.begin();
  }

  private Plan around(
      Station station, StateInformation state, Vehicle vehicle, NavigationPoint onCircle) {
    double accuracyM = settings.get().approachAccuracy();
    Plan plan =
        detour.step(
            vehicle,
            state,
            new Avoidance.Wanted(
                station.uid(),
                circle.at(entryRad),
                accuracyM,
                OptionalDouble.of(circle.courseRad(entryRad)),
                station.speed()));
    long micros = vehicle.timestampMicros();
    lostSince = detour.hasRoute() ? Long.MAX_VALUE : Math.min(lostSince, micros);
    boolean isLost =
        plan.progress() == Plan.Progress.ABANDONED
            || lostSince != Long.MAX_VALUE && micros - lostSince > Clock.micros(UNREACHABLE_S);
    if (!isLost) {
      return plan;
    }
    if (entry == ENTRIES && !endless) {
      return new Plan(
          plan.points(), Plan.Progress.ABANDONED, "given up: no part of the circle can be reached");
    }
    enter(entry % ENTRIES + 1, vehicle);
    return Plan.underWay(plan.points());
  }

  private void count(Station station, Vehicle vehicle) {
    double now = circle.bearingRad(vehicle);
    double downM = vehicle.nedOf(circle.at(now)).z();
    double tolerance = station.verticalThreshold().orElse(settings.get().takeOffAccuracyM(true));
    if (sinceMicros != Long.MIN_VALUE) {
      double turned = circle.sense() * Leg.wrapped(now - bearingRad);
      turnedRad += Double.isNaN(turned) ? 0.0 : turned;
    } else if (Math.abs(circle.outsideM(vehicle)) < settings.get().approachAccuracy()
        && Math.abs(downM) <= tolerance) {
      sinceMicros = vehicle.timestampMicros();
    }
    if (sinceMicros == Long.MIN_VALUE || turnedRad > farthestRad) {
      farthestRad = turnedRad;
      farthestMicros = vehicle.timestampMicros();
    }
    bearingRad = now;
  }

  /**
   * Moves the point ahead outwards while the vehicle circles too near: a control that steers
   * straight at the point, rather than along an arc to it, cuts the circle.
   */
  private void widen(Vehicle vehicle) {
    double seconds = Clock.seconds(vehicle.timestampMicros() - widenedMicros);
    widenedMicros = vehicle.timestampMicros();
    double insideM = -circle.outsideM(vehicle);
    boolean isOff = Math.abs(insideM) > SLACK * circle.radiusM();
    if (sinceMicros != Long.MIN_VALUE && entry == 0 && isOff && seconds < LONGEST_STEP_S) {
      double wider = widerM + WIDENS_PER_S * seconds * insideM;
      widerM = Math.max(0.0, Math.min(MAX_WIDER * circle.radiusM(), wider));
    }
  }

  private boolean isOver(Station station, Vehicle vehicle) {
    boolean isLimited = station.duration().isPresent() || station.turns().isPresent();
    return isLimited
        && sinceMicros != Long.MIN_VALUE
        && keptS(vehicle) >= station.duration().orElse(0.0)
        && turns() >= station.turns().orElse(0.0);
  }

  private double keptS(Vehicle vehicle) {
    return Clock.seconds(vehicle.timestampMicros() - sinceMicros);
  }

  private double turns() {
    return turnedRad / (2.0 * Math.PI);
  }

  /**
   * Whether it is on its course to the next goal, if the station requires this; true anywhere
   * inside the circle.
   */
  private boolean mayLeave(Station station, Vehicle vehicle, Optional<GoalInformation> after) {
    Optional<Place> next =
        after
            .filter(goal -> station.towardsNext() && goal instanceof Waypoint)
            .map(goal -> Place.of((Waypoint) goal))
            .filter(Place::isHorizontal)
            .filter(place -> circle.outsideM(place, vehicle) > 0.0);
    if (next.isEmpty()) {
      return true;
    }
    Point to = vehicle.nedOf(next.get());
    double turn = circle.sense() * Leg.wrapped(Math.atan2(to.y(), to.x()) - vehicle.courseRad());
    return turn >= 0.0 && turn <= LEAVES_RAD;
  }

  private String counted(Vehicle vehicle) {
    return String.format(Locale.ROOT, "circled for %.1f s, %.1f turns", keptS(vehicle), turns());
  }
}
