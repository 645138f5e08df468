package org.u2sa.planning;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.SearchArea;
import org.u2sa.messages.shape.CoverageLedger;
import org.u2sa.planning.avoidance.Avoidance;
import org.u2sa.planning.avoidance.AvoidanceVariables;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.goals.PursuitTime;
import org.u2sa.planning.guidance.LineSettings;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.guidance.WaypointGuidance;
import org.u2sa.planning.seen.PlanningPlane;
import org.u2sa.planning.survey.LaneLegs;
import org.u2sa.planning.survey.SurveyHeights;
import org.u2sa.planning.survey.SurveyVariables;

/**
 * Flies over a {@link SearchArea} in lanes until the World Modeler's record of it has no gaps: lays
 * lanes over the missing parts, flies them, and checks again (thesis 4.4.2). It leaves its lane to
 * avoid obstacles and traffic; missed parts are flown again.
 */
final class SearchAreaState implements PlannerState {
  private static final double LEDGER_WITHIN_S = 15.0;
  private static final double SETTLES_S = 3.0; // time until the last images are in the record
  private static final double RECORDS_S = 1.0; // interval between two checks of the record
  private static final double UNREACHABLE_S = 4.0; // time without a route

  private final Avoidance avoidance;
  private final WaypointGuidance guidance;
  private final Supplier<SurveyVariables> survey;
  private final Supplier<AvoidanceVariables> seeing;
  private final Supplier<LineSettings> lines;
  private final SurveyHeights heights;
  private final PursuitTime time;
  private final Deque<LaneLegs.Leg> legs = new ArrayDeque<>();
  private PlanningPlane plane; // plane of the legs
  private boolean isAlong; // on its lane, after the transit to it
  private boolean evades;
  private boolean isReversed; // reversed, because it cannot be entered from its other end
  private long lostSince; // pursuit time since when there is no route; MAX_VALUE with one
  private int passes;
  private long waitsSince; // since when it waits for the record
  private long looksAfter;

  SearchAreaState(
      Avoidance avoidance,
      WaypointGuidance guidance,
      Supplier<SurveyVariables> survey,
      Supplier<AvoidanceVariables> seeing,
      Supplier<LineSettings> lines,
      SurveyHeights heights,
      PursuitTime time) {
    this.avoidance = avoidance;
    this.guidance = guidance;
    this.survey = survey;
    this.seeing = seeing;
    this.lines = lines;
    this.heights = heights;
    this.time = time;
  }

  @Override
  public Class<? extends GoalInformation> goalClass() {
    return SearchArea.class;
  }

  @Override
  public double distanceM(GoalInformation goal, StateInformation state) {
    SearchArea area = (SearchArea) goal;
    Point to =
        Vehicle.of(state)
            .orElseThrow()
            .nedOf(Place.of(area.referenceFrame(), area.corners().get(0)));
    return Math.hypot(to.x(), to.y());
  }

  @Override
  public void enter(Pursuit pursuit) {
    legs.clear();
    isReversed = false;
    passes = 0;
    waitsSince = pursuit.state().timestamp().orElse(0L);
    looksAfter = Long.MIN_VALUE;
    begin();
  }

  private void begin() {
    isAlong = false;
    evades = false;
    lostSince = Long.MAX_VALUE;
    guidance.begin(Optional.empty());
    avoidance.begin();
  }

  @Override
  public Plan plan(Pursuit pursuit) {
    SearchArea area = (SearchArea) pursuit.goal();
    Vehicle vehicle = Vehicle.of(pursuit.state()).orElseThrow();
    PlanningPlane now = avoidance.world().plane(pursuit.state());
    long micros = vehicle.timestampMicros();
    if (now != plane) {
      plane = now;
      legs.clear();
    }
    Optional<CoverageLedger> ledger = LaneLegs.ledger(area, avoidance.world().objects());
    if (legs.isEmpty() && micros >= looksAfter) {
      if (ledger.isEmpty()) {
        boolean late = micros - waitsSince > Clock.micros(LEDGER_WITHIN_S);
        return late
            ? ended(area, vehicle, Plan.Progress.ABANDONED, "nothing records the cells seen", 0.0)
            : Plan.underWay(List.of(straightOn(area, vehicle)));
      }
      return look(area, ledger.get(), vehicle, pursuit.state());
    }
    if (legs.isEmpty()) {
      return Plan.underWay(List.of(straightOn(area, vehicle)));
    }
    return Plan.underWay(List.of(fly(area, vehicle, pursuit.state(), ledger)));
  }

  /** Ends the pursuit, or lays lanes over the missing parts. */
  private Plan look(
      SearchArea area, CoverageLedger ledger, Vehicle vehicle, StateInformation state) {
    double share = ledger.share(area.resolution());
    if (share >= area.share().orElse(1.0)) {
      return ended(area, vehicle, Plan.Progress.COMPLETED, "seen", share);
    }
    Optional<String> fault = LaneLegs.fault(area, ledger, survey.get());
    if (fault.isPresent()) {
      return ended(area, vehicle, Plan.Progress.ABANDONED, fault.get(), share);
    }
    if (passes >= survey.get().surveyPasses()) {
      return ended(area, vehicle, Plan.Progress.ABANDONED, "given up", share);
    }
    Point at = vehicle.on(plane);
    Pose pose = new Pose(at.x(), at.y(), vehicle.courseRad());
    legs.addAll(
        LaneLegs.over(area, ledger, plane, pose, flight(area, state, vehicle), survey.get()));
    passes++;
    begin();
    String remark =
        String.format(
            Locale.ROOT, "pass %d: %d lanes, %.1f %% seen", passes, legs.size(), 100.0 * share);
    NavigationPoint on = straightOn(area, vehicle);
    return new Plan(List.of(on), Plan.Progress.UNDER_WAY, remark);
  }

  private LaneLegs.Wind flight(SearchArea area, StateInformation state, Vehicle vehicle) {
    AvoidanceVariables now = seeing.get();
    double airspeed = area.speed().orElse(Math.max(now.plannedSpeed(), now.minSpeed()));
    double through = state.fluidxDot().orElse(vehicle.speedMps());
    double north = vehicle.northMps() - through * Math.cos(vehicle.headingRad());
    double east = vehicle.eastMps() - through * Math.sin(vehicle.headingRad());
    double radius =
        now.turnRadius() > 0.0
            ? now.turnRadius()
            : lines.get().turns().radiusM(airspeed + Math.hypot(north, east));
    return new LaneLegs.Wind(airspeed, radius, north, east);
  }

  private Plan ended(
      SearchArea area, Vehicle vehicle, Plan.Progress progress, String what, double share) {
    String remark =
        String.format(
            Locale.ROOT,
            "%s: %.1f %% at %.3f m per pixel, %d passes",
            what,
            100.0 * share,
            area.resolution(),
            passes);
    return new Plan(List.of(straightOn(area, vehicle)), progress, remark)
        .changing(area.copy().seen(share));
  }

  /** Flies straight on at the altitude of the area. */
  private NavigationPoint straightOn(SearchArea area, Vehicle vehicle) {
    Point at = vehicle.on(plane);
    double ahead = 2.0 * lines.get().lookAheadM(vehicle.speedMps());
    Pose now = new Pose(at.x(), at.y(), vehicle.courseRad());
    return straightTo(area, vehicle, now.along(ahead, 0.0));
  }

  private NavigationPoint straightTo(SearchArea area, Vehicle vehicle, Pose to) {
    NavigationPoint point = NavigationPoint.at(vehicle.body(vehicle.nedOf(place(to, area))));
    area.speed().ifPresent(point::speed);
    return point;
  }

  private NavigationPoint fly(
      SearchArea area, Vehicle vehicle, StateInformation state, Optional<CoverageLedger> ledger) {
    LaneLegs.Leg leg = legs.peek();
    Point at = vehicle.on(plane);
    if (!isAlong && ledger.isPresent() && leg.isSeen(ledger.get(), area.resolution())) {
      next(vehicle);
      return straightOn(area, vehicle);
    }
    boolean isThere =
        (avoidance.turnsOnTheSpot() && leg.isNear(at.x(), at.y()))
            || (!avoidance.isOn() && guidance.hasPassed());
    if (!isAlong && (isThere || leg.isEntered(at.x(), at.y(), vehicle.courseRad()))) {
      isAlong = true;
      evades = false;
    }
    if (isAlong && leg.isPassed(at.x(), at.y())) {
      next(vehicle);
      return straightOn(area, vehicle);
    }
    if (!isAlong) {
      return towards(area, vehicle, state, leg.entry());
    }
    boolean hindered =
        avoidance.isOn() && avoidance.straight().isHindered(vehicle, state, place(leg.end(), area));
    if (hindered != evades) {
      evades = hindered;
      avoidance.begin();
    }
    return evades
        ? towards(area, vehicle, state, leg.end())
        : straightTo(
            area, vehicle, leg.ahead(at.x(), at.y(), lines.get().lookAheadM(vehicle.speedMps())));
  }

  private void next(Vehicle vehicle) {
    legs.remove();
    isReversed = false;
    begin();
    double waitS = legs.isEmpty() ? SETTLES_S : RECORDS_S;
    looksAfter = vehicle.timestampMicros() + Clock.micros(waitS);
  }

  private Place place(Pose pose, SearchArea area) {
    return Place.of(plane.frame(), heights.point(area, survey.get(), plane, pose));
  }

  /** Flies to a pose, around obstacles and traffic if the planner avoids them. */
  private NavigationPoint towards(
      SearchArea area, Vehicle vehicle, StateInformation state, Pose to) {
    Place place = place(to, area);
    double near = lines.get().lookAheadM(vehicle.speedMps());
    if (!avoidance.isOn()) {
      NavigationPoint point =
          NavigationPoint.at(guidance.towards(vehicle, place, near, Optional.empty()));
      area.speed().ifPresent(point::speed);
      return point;
    }
    Avoidance.Step step =
        avoidance.step(
            vehicle,
            state,
            new Avoidance.Wanted(
                area.uid(), place, near, OptionalDouble.of(to.headingRad()), area.speed()));
    long micros = time.micros();
    lostSince = avoidance.remainingM().isPresent() ? Long.MAX_VALUE : Math.min(lostSince, micros);
    if (step.givenUp().isPresent() || micros - lostSince > Clock.micros(UNREACHABLE_S)) {
      leave(vehicle);
    }
    return step.point(vehicle);
  }

  /**
   * If the lane cannot be entered, flies it in the other direction, or else skips it: its cells
   * remain missing and are retried.
   */
  private void leave(Vehicle vehicle) {
    if (isAlong || isReversed) {
      next(vehicle);
      return;
    }
    legs.addFirst(legs.remove().reversed());
    isReversed = true;
    begin();
  }
}
