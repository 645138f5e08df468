package org.u2sa.planning;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.Landing;
import org.u2sa.messages.goal.Station;
import org.u2sa.planning.avoidance.Avoidance;
import org.u2sa.planning.flight.FlightVariables;
import org.u2sa.planning.guidance.AirMass;
import org.u2sa.planning.guidance.LineGuidance;
import org.u2sa.planning.guidance.LineSettings;
import org.u2sa.planning.guidance.LineSettings.AltitudeProfile;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.service.handover.HandOver;

/**
 * Landing of an aeroplane: to a point on the extended centreline, around obstacles if the planner
 * avoids them, circling there to the approach altitude, level along the line, then down the slope
 * and along the runway. Control flares. The approach is repeated if it is off the line at the start
 * of the descent, if it is obstructed before that, if traffic comes close above MIN_BREAK_OFF_M, or
 * if the aeroplane still flies beyond the position. With an obstacle on the slope it lands in
 * another direction, or gives up if the goal requires the direction.
 */
final class StraightApproach implements LandingState.Descent {
  /** Lengths of the level part to try, in radii of downwind turns. */
  private static final double[] LEAD_RADII = {3.0, 2.0, 4.5, 1.5};

  private static final double MOVED_M = 1.0; // a goal that another update leaves in its place
  private static final long NOT_YET = Long.MAX_VALUE;
  private static final double ROLL_OUT_M = 500.0; // length of the line beyond the position
  private static final double PASSED_M = 50.0; // this far beyond the position …
  private static final double HIGH_M = 10.0; // … and this high, control has refused to land
  private static final double FLIES_ON_S = 10.0; // after the position, whatever its height, …
  private static final double FLIES_ON_SHARE = 0.9; // … if it has kept its speed over ground …
  private static final double FLIES_ON_MPS = 5.0; // … and does not creep
  private static final double FAR_M = 1000.0; // from the position: not on its runway, …
  private static final double FAR_RADII = 4.0; // … nor so many radii of downwind turns
  private static final double ALONG_RAD = Math.toRadians(30.0); // maximum course error on the line
  private static final int ATTEMPTS = 3;
  private static final int BREAK_OFFS = 6;
  private static final double MIN_BREAK_OFF_M = 20.0; // above the position
  private static final String CLIMBS = "CLIMBS";
  private static final int DIRECTIONS = 12;

  private enum Phase {
    /** Flying to the point on the extended centreline. */
    JOIN,
    /** Circling there. */
    CIRCLE,
    /** Flying level along the line. */
    LEVEL,
    /** Descending on the slope, and on the ground. */
    DOWN
  }

  private final Detour detour;
  private final Supplier<LineSettings> lines;
  private final StationCircle circle;
  private final Supplier<FlightVariables> settings;
  private final LineGuidance guidance;
  private Phase phase = Phase.JOIN;
  private int attempts;
  private int breakOffs;
  private boolean leaves; // leaving the line on which the approach was aborted
  private boolean climbs; // straight on, before it may turn
  private OptionalDouble psi = OptionalDouble.empty(); // direction required by the goal
  private Place touchDown; // at which the descent is aimed
  private long passedMicros = NOT_YET; // when it passed the position
  private double passedMps; // speed over ground then
  private double courseRad;
  private double radiusM;
  private int lead; // index in LEAD_RADII

  StraightApproach(
      Detour detour,
      Supplier<LineSettings> lines,
      StationCircle circle,
      Supplier<FlightVariables> settings) {
    this.detour = detour;
    this.lines = lines;
    this.circle = circle;
    this.settings = settings;
    guidance = new LineGuidance(this::level);
  }

  private LineSettings level() {
    LineSettings now = lines.get();
    return new LineSettings(
        now.leastLookAheadM(), now.lookAheadS(), now.turns(), AltitudeProfile.IMMEDIATE);
  }

  @Override
  public void begin(Landing goal, StateInformation state, Vehicle vehicle) {
    attempts = 1;
    breakOffs = 0;
    leaves = false;
    climbs = false;
    psi = goal.psi();
    Point to = vehicle.nedOf(Place.of(goal));
    Optional<Point> wind = AirMass.wind(state, vehicle);
    courseRad =
        psi.orElseGet(
            () ->
                wind.map(towards -> Math.atan2(-towards.y(), -towards.x()))
                    .orElse(Math.atan2(to.y(), to.x())));
    double fastestMps = // ground speed
        state.fluidxDot().orElse(vehicle.speedMps()) + wind.map(Point::distance).orElse(0.0);
    radiusM = lines.get().turns().radiusM(fastestMps);
    lead = 0;
    join();
  }

  private void join() {
    phase = Phase.JOIN;
    passedMicros = NOT_YET;
    circle.leave();
    guidance.begin(Optional.empty());
    detour.begin();
  }

  @Override
  public Plan plan(Landing goal, StateInformation state, Vehicle vehicle) {
    Place place = Place.of(goal);
    double lengthM = goal.approach().orElse(settings.get().approachLength());
    double slope = slope(goal);
    double highM = place.upM().orElseThrow() + lengthM * slope;
    boolean isHigh = phase != Phase.DOWN || vehicle.nedOf(place).z() > MIN_BREAK_OFF_M;
    boolean isMoved = phase == Phase.DOWN && hasMoved(vehicle, place);
    if (isMoved && isHigh || isHigh && !psi.equals(goal.psi())) {
      begin(goal, state, vehicle);
      climbs = isMoved; // a turn on the slope would end low and beside the runway
    } else if (isMoved) {
      place = touchDown; // too late
    }
    if (isHigh && blocksDescent(vehicle, state, place, lengthM, highM)) {
      return elsewhere(goal, state, vehicle, highM);
    }
    Place entry = onLine(place, -lengthM - LEAD_RADII[lead] * radiusM).at(highM);
    Place end = onLine(place, ROLL_OUT_M);
    Point to = vehicle.nedOf(place);
    double remainingM = to.x() * Math.cos(courseRad) + to.y() * Math.sin(courseRad);
    Point toEntry = vehicle.nedOf(entry);
    proceed(vehicle, entry, toEntry, remainingM > lengthM);
    double share = vehicle.downMps() > 0.0 ? 1.0 : 0.5; // of the height of the approach
    climbs &= to.z() < share * lengthM * slope;
    if (climbs) {
      return Plan.underWay(List.of(up(vehicle, place, highM)));
    }
    if (phase == Phase.JOIN && detour.isPossible()) {
      return around(goal, state, vehicle, entry);
    }
    if (phase == Phase.JOIN) {
      return underWay(
          guidance.towards(vehicle, entry, settings.get().approachAccuracy(), Optional.of(end)));
    }
    if (phase == Phase.CIRCLE) {
      Station around = new Station().uid(goal.uid()); // until at the approach altitude
      return circle.plan(around, state, vehicle, entry, Optional.empty());
    }
    boolean isBlocked =
        phase == Phase.LEVEL
            ? detour.isObstructed(vehicle, state, ahead(place, remainingM, lengthM).at(highM))
            : to.z() > MIN_BREAK_OFF_M && detour.comesTraffic(vehicle, state, place);
    if (isBlocked) {
      return breakOff(vehicle.body(toEntry));
    }
    double acrossM = to.x() * Math.sin(courseRad) - to.y() * Math.cos(courseRad);
    if (phase == Phase.LEVEL && remainingM <= lengthM) {
      double most = settings.get().approachAccuracy();
      if (Math.abs(acrossM) > most || Math.abs(toEntry.z()) > most) {
        return again(off(acrossM, toEntry.z()), vehicle.body(toEntry));
      }
      phase = Phase.DOWN;
      touchDown = place;
    }
    if (remainingM < -PASSED_M && to.z() > HIGH_M) {
      return again(off(acrossM, to.z()), vehicle.body(toEntry));
    }
    if (fliesOn(vehicle, remainingM)) {
      return again("flies on beyond the position", vehicle.body(toEntry));
    }
    double aheadM = remainingM - lines.get().lookAheadM(vehicle.speedMps());
    double altitudeM = place.upM().orElseThrow() + slope * Math.max(0.0, Math.min(lengthM, aheadM));
    Point body = guidance.towards(vehicle, end.at(altitudeM), 1.0, Optional.empty());
    NavigationPoint point = NavigationPoint.at(body);
    goal.speed().ifPresent(point::speed);
    return Plan.underWay(List.of(point));
  }

  /** {@inheritDoc} An aeroplane that does not move is not flying. */
  @Override
  public boolean isFinal() {
    return true;
  }

  @Override
  public double farM(Landing goal) {
    return Math.max(FAR_M, FAR_RADII * radiusM);
  }

  @Override
  public String manoeuvre() {
    return climbs ? CLIMBS : phase == Phase.DOWN ? phase.name() : "";
  }

  @Override
  public void handOver(HandOver state) {
    state.text("APPROACH PHASE", phase.name());
    state.number("APPROACHES", attempts).number("BREAK-OFFS", breakOffs).number("LEAD", lead);
    state.flag("LEAVES LINE", leaves).flag("CLIMBS FIRST", climbs);
    psi.ifPresent(given -> state.number("LANDING HEADING", given));
    state.number("LANDING COURSE", courseRad).number("TURN RADIUS", radiusM);
    if (touchDown != null) {
      touchDown.handOver(state, "TOUCH-DOWN");
    }
    if (passedMicros != NOT_YET) {
      state.number("PASSED POSITION", Clock.seconds(passedMicros)).number("PASSED AT", passedMps);
    }
    guidance.handOver(state);
    circle.handOver(state, "CIRCLE");
  }

  @Override
  public boolean takeOver(HandOver state) {
    Optional<Phase> taken = state.text("APPROACH PHASE").map(Phase::valueOf);
    touchDown = Place.takenOver(state, "TOUCH-DOWN").orElse(null);
    if (taken.isEmpty() || taken.get() == Phase.DOWN && touchDown == null) {
      return false;
    }
    phase = taken.get();
    attempts = (int) state.number("APPROACHES").orElse(1.0);
    breakOffs = (int) state.number("BREAK-OFFS").orElse(0.0);
    lead = (int) state.number("LEAD").orElse(0.0);
    leaves = state.flag("LEAVES LINE");
    climbs = state.flag("CLIMBS FIRST");
    psi = state.number("LANDING HEADING");
    courseRad = state.number("LANDING COURSE").orElseThrow();
    radiusM = state.number("TURN RADIUS").orElseThrow();
    OptionalDouble passed = state.number("PASSED POSITION");
    passedMicros = passed.isPresent() ? Clock.micros(passed.getAsDouble()) : NOT_YET;
    passedMps = state.number("PASSED AT").orElse(0.0);
    guidance.begin(Optional.empty());
    guidance.takeOver(state);
    circle.takeOver(state, "CIRCLE");
    detour.begin();
    return true;
  }

  /** {@inheritDoc} A descent, along its line before or on the runway; a climb straight on. */
  @Override
  public boolean isStillIn(String manoeuvre, Landing goal, Vehicle vehicle) {
    if (manoeuvre.equals(CLIMBS)) {
      return true; // until it is high enough
    }
    Point to = vehicle.nedOf(Place.of(goal));
    double lengthM = goal.approach().orElse(settings.get().approachLength());
    double remainingM = to.x() * Math.cos(courseRad) + to.y() * Math.sin(courseRad);
    double accuracyM = settings.get().approachAccuracy();
    boolean isOnSlope = remainingM < lengthM + accuracyM && remainingM > -ROLL_OUT_M;
    return manoeuvre.equals(Phase.DOWN.name())
        && isOnSlope
        && isAlong(vehicle, to)
        && to.z() < slope(goal) * Math.max(0.0, remainingM) + accuracyM;
  }

  private double slope(Landing goal) {
    return Math.tan(goal.slope().orElse(Math.toRadians(settings.get().approachSlope())));
  }

  /** Whether it has passed the position without touching down, which would have slowed it. */
  private boolean fliesOn(Vehicle vehicle, double remainingM) {
    long now = vehicle.timestampMicros();
    if (passedMicros == NOT_YET && remainingM < 0.0) {
      passedMicros = now;
      passedMps = vehicle.speedMps();
    }
    return passedMicros != NOT_YET
        && Clock.seconds(now - passedMicros) > FLIES_ON_S
        && vehicle.speedMps() > Math.max(FLIES_ON_MPS, FLIES_ON_SHARE * passedMps);
  }

  /** Whether the goal is no longer where the descent leads. */
  private boolean hasMoved(Vehicle vehicle, Place goal) {
    Point to = vehicle.nedOf(goal);
    Point before = vehicle.nedOf(touchDown);
    return Math.hypot(to.x() - before.x(), to.y() - before.y()) > MOVED_M;
  }

  private boolean blocksDescent(
      Vehicle vehicle, StateInformation state, Place place, double lengthM, double highM) {
    Place from = onLine(place, -lengthM).at(highM);
    return detour.blocksDescent(vehicle, state, from, place);
  }

  /** Lands in the nearest direction whose slope is free, unless the goal has a direction. */
  private Plan elsewhere(Landing goal, StateInformation state, Vehicle vehicle, double highM) {
    Place place = Place.of(goal);
    double lengthM = goal.approach().orElse(settings.get().approachLength());
    double blockedRad = courseRad;
    for (int i = 1; goal.psi().isEmpty() && i < DIRECTIONS; i++) {
      int side = i % 2 == 0 ? -1 : 1;
      courseRad = blockedRad + side * ((i + 1) / 2) * 2.0 * Math.PI / DIRECTIONS;
      if (!blocksDescent(vehicle, state, place, lengthM, highM)) {
        lead = 0;
        join();
        String remark = "an obstacle blocks the descent; landing in another direction";
        return new Plan(List.of(up(vehicle, place, highM)), Plan.Progress.UNDER_WAY, remark);
      }
    }
    courseRad = blockedRad;
    return new Plan(
        List.of(up(vehicle, place, highM)),
        Plan.Progress.ABANDONED,
        "given up: an obstacle blocks the descent");
  }

  /** Flies straight on, climbing or descending to the altitude of the approach. */
  private NavigationPoint up(Vehicle vehicle, Place place, double highM) {
    double ahead = 2.0 * lines.get().lookAheadM(vehicle.speedMps());
    Point ned =
        Point.of(
            ahead * Math.cos(vehicle.courseRad()),
            ahead * Math.sin(vehicle.courseRad()),
            vehicle.nedOf(place.at(highM)).z());
    return NavigationPoint.at(vehicle.body(ned));
  }

  /** Flies to the entry, in the direction of the line. */
  private Plan around(Landing goal, StateInformation state, Vehicle vehicle, Place entry) {
    Plan plan =
        detour.step(
            vehicle,
            state,
            new Avoidance.Wanted(
                goal.uid(),
                entry,
                settings.get().approachAccuracy(),
                OptionalDouble.of(courseRad),
                OptionalDouble.empty()));
    if (plan.progress() != Plan.Progress.ABANDONED || lead == LEAD_RADII.length - 1) {
      return plan;
    }
    lead++;
    detour.begin();
    return new Plan(
        List.copyOf(plan.points()),
        Plan.Progress.UNDER_WAY,
        plan.remark() + "; going to another point on the centreline");
  }

  /** Look-ahead point on the level line, as far ahead as the line reaches. */
  private Place ahead(Place place, double remainingM, double lengthM) {
    return onLine(place, -Math.max(lengthM, remainingM - lengthM));
  }

  private Plan breakOff(Point body) {
    List<NavigationPoint> points = List.of(NavigationPoint.at(body));
    if (breakOffs >= BREAK_OFFS) {
      return new Plan(points, Plan.Progress.ABANDONED, "given up: the approach is obstructed");
    }
    breakOffs++;
    leaves = true;
    join();
    return new Plan(points, Plan.Progress.UNDER_WAY, "the approach is obstructed: trying again");
  }

  /** A point on the centreline, a distance before the position. */
  private Place onLine(Place place, double behindM) {
    return place.moved(behindM * Math.cos(courseRad), behindM * Math.sin(courseRad));
  }

  /** Changes the phase on the way to the entry and at it. */
  private void proceed(Vehicle vehicle, Place entry, Point toEntry, boolean isBeforeDescent) {
    double accuracyM = settings.get().approachAccuracy();
    boolean isOnLine = isOnLine(vehicle, toEntry);
    leaves &= isOnLine;
    boolean isThere =
        detour.isPossible()
            ? isOnLine && !leaves && isBeforeDescent
            : guidance.isApproaching() && guidance.hasPassed()
                || Math.hypot(toEntry.x(), toEntry.y()) < accuracyM;
    boolean isLevel = Math.abs(toEntry.z()) < accuracyM / 2.0;
    if (phase == Phase.JOIN && isThere && !isLevel && circle.isCircling()) {
      phase = Phase.CIRCLE;
    } else if (phase == Phase.JOIN && isThere) {
      phase = Phase.LEVEL;
      guidance.begin(Optional.of(entry));
    } else if (phase == Phase.CIRCLE && isLevel) {
      join();
    }
  }

  /** Whether the vehicle flies along the line, at the entry or beyond it. */
  private boolean isOnLine(Vehicle vehicle, Point toEntry) {
    double toGoM = toEntry.x() * Math.cos(courseRad) + toEntry.y() * Math.sin(courseRad);
    return toGoM < settings.get().approachAccuracy() && isAlong(vehicle, toEntry);
  }

  /** Whether the vehicle flies along the line through a point. */
  private boolean isAlong(Vehicle vehicle, Point to) {
    double acrossM = to.x() * Math.sin(courseRad) - to.y() * Math.cos(courseRad);
    double turn = Math.IEEEremainder(vehicle.courseRad() - courseRad, 2.0 * Math.PI);
    return Math.abs(acrossM) < settings.get().approachAccuracy() && Math.abs(turn) < ALONG_RAD;
  }

  private Plan again(String off, Point body) {
    List<NavigationPoint> points = List.of(NavigationPoint.at(body));
    if (attempts >= ATTEMPTS) {
      return new Plan(points, Plan.Progress.ABANDONED, "given up: " + off);
    }
    attempts++;
    leaves = true;
    climbs = true;
    join();
    return new Plan(points, Plan.Progress.UNDER_WAY, off + ": trying again");
  }

  private static String off(double acrossM, double aboveM) {
    return String.format(
        Locale.ROOT, "the approach is %.0f m off the line and %.0f m too high", acrossM, aboveM);
  }

  private static Plan underWay(Point body) {
    return Plan.underWay(List.of(NavigationPoint.at(body)));
  }
}
