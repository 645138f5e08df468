package org.u2sa.planning;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.terrain.HeightGrid;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.mission.MissionReport;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.planning.avoidance.Avoidance;
import org.u2sa.planning.avoidance.AvoidanceVariables;
import org.u2sa.planning.flight.FlightChecks;
import org.u2sa.planning.flight.FlightVariables;
import org.u2sa.planning.flight.TakeOffWatch;
import org.u2sa.planning.goals.GoalChoice;
import org.u2sa.planning.goals.PursuitTime;
import org.u2sa.planning.guidance.ChosenGuidance;
import org.u2sa.planning.guidance.HeadwayWatch;
import org.u2sa.planning.guidance.LineSettings;
import org.u2sa.planning.guidance.LineSettings.AltitudeProfile;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.guidance.ViewPoints;
import org.u2sa.planning.guidance.WaypointAccuracy;
import org.u2sa.planning.guidance.WaypointGuidance;
import org.u2sa.planning.payload.PayloadReleases;
import org.u2sa.planning.rightofway.RightOfWayVariables;
import org.u2sa.planning.rightofway.RightOfWayWatch;
import org.u2sa.planning.station.StationVariables;
import org.u2sa.planning.survey.SurveyHeights;
import org.u2sa.planning.survey.SurveyVariables;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.FirstFailsafe;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.handover.HandOver;

/**
 * Plans the path to the current goal (thesis 3.2.3.4): a state machine with one state per class of
 * goals. In: state, goals, failsafe, manual-state, fence, actuators; with TERRAIN mission. Out:
 * navigation, goal-reports; with TERRAIN mission (requests).
 *
 * <p>It plans once per state estimate, so without fresh states it publishes no navigation points.
 * On request of a failsafe it holds its position, as at the mission's end, or publishes none. The
 * same class serves aircraft and ground vehicles; only their configuration differs (thesis
 * 4.6.2.3).
 */
public class PathPlanner extends EventDrivenService {
  private final Settings<PlanningVariables> settings = settings(PlanningVariables.class);
  private final PlannerStates states;
  private final EndOfMission end;
  private final GroundStay ground;
  private final Avoidance avoidance;
  private final RightOfWayWatch rightOfWay;
  private final BlindStand blind;
  private final Detour detour;
  private final FlightChecks checks;
  private final Optional<TerrainLimits> terrainLimits;
  private final TakeOffWatch takeOff = new TakeOffWatch();
  private final GoalReports reports;
  private final PlannerOrders orders = new PlannerOrders();
  private final PursuitTime time = new PursuitTime();
  private final PlannerRemarks remarks = new PlannerRemarks(this, () -> this.goal);
  private final ViewPoints view = new ViewPoints(settings(ViewPoints.Variables.class));
  private Optional<GoalInformation> goal = Optional.empty(); // goal being pursued
  private Optional<Place> holdAt = Optional.empty(); // last goal position reached or abandoned
  private Optional<HandOver> interrupted = Optional.empty(); // by a restart
  private String foreseen = ""; // UID of the goal expected next
  private long stateMicros = Long.MIN_VALUE; // arrival of the last state

  public PathPlanner(ServiceContext context) {
    this(context, planner -> new ChosenGuidance(planner, planner::lines));
  }

  /**
   * @param guide creates the guidance; may read further variables of the planner
   */
  PathPlanner(ServiceContext context, Function<PathPlanner, WaypointGuidance> guide) {
    super(context, ServiceRole.PATH_PLANNER, "PathPlanner");
    WaypointGuidance guidance = guide.apply(this);
    Settings<AvoidanceVariables> seeing = settings(AvoidanceVariables.class);
    Settings<SurveyVariables> survey = settings(SurveyVariables.class);
    Optional<HeightGrid> terrain =
        HeightGrid.named(survey.get().terrain(), context.configuration()::resolve);
    avoidance =
        new Avoidance(
            this,
            seeing,
            this::lines,
            time,
            remarks::say,
            terrain,
            () -> survey.get().surveyClimb());
    terrainLimits =
        terrain.map(
            map ->
                new TerrainLimits(
                    this,
                    map,
                    survey.get().terrain(),
                    () -> avoidance.isOn() && seeing.get().verticalClearance() > 0.0));
    rightOfWay =
        new RightOfWayWatch(
            settings(RightOfWayVariables.class),
            seeing,
            this::lines,
            avoidance.world(),
            remarks::say,
            this::remark);
    blind = new BlindStand(this, avoidance, () -> avoidance.isOn() || rightOfWay.isOn(), seeing);
    reports =
        new GoalReports(
            report -> publish(Channels.GOAL_REPORTS, report),
            () -> settings.get().reportIntervalMicros());
    detour = new Detour(avoidance);
    Settings<FlightVariables> flight = settings(FlightVariables.class);
    ground = new GroundStay(flight, this::isAeroplane);
    Settings<StationVariables> stations = settings(StationVariables.class);
    Function<Boolean, StationCircle> circles =
        endless ->
            new StationCircle(
                detour,
                this::lines,
                () -> settings.get().loiterRadius(),
                flight,
                () -> stations.get().stationGiveUpAfter(),
                endless);
    StationCircle circle = circles.apply(false);
    PayloadReleases releases = new PayloadReleases();
    states =
        new PlannerStates(
            List.of(
                new WaypointState(guidance, settings, avoidance, rightOfWay, seeing, detour, time),
                new ObjectGoalState(avoidance, seeing, time),
                new StationState(
                    guidance, stations, circle, detour, () -> seeing.get().drifts(), time),
                new SearchAreaState(
                    avoidance,
                    guidance,
                    survey,
                    seeing,
                    this::lines,
                    new SurveyHeights(terrain),
                    time),
                new TakeOffState(this::lines, flight, this::isAeroplane),
                new LandingState(detour, this::lines, circle, flight),
                new PayloadDropState(detour, this::lines, flight, releases)));
    states.discover(this, new PlannerSurroundings(avoidance, this::missionS));
    checks =
        new FlightChecks(
            avoidance,
            new HeadwayWatch(remarks::trouble, this::remark),
            new FlightChecks.Aircraft(
                () -> ground.flies() && !orders.isByHand(),
                this::isAeroplane,
                ground::stoodAt,
                () -> flight.get().headwayTime()));
    end =
        new EndOfMission(
            settings,
            () -> seeing.get().drifts(),
            guidance,
            ground::raised,
            circles.apply(true),
            detour);
    registerPublisher(Channels.NAVIGATION);
    registerPublisher(Channels.GOAL_REPORTS);
    registerPublisher(Channels.PLANS);
    if (terrainLimits.isPresent()) {
      registerPublisher(Channels.MISSION);
      subscribe(Channels.MISSION, this::onMission);
    }
    subscribe(Channels.GOALS, this::onGoals);
    subscribe(Channels.OBJECTS, this::onObjects);
    subscribe(Channels.GRID, grid -> avoidance.world().see(grid, clock().micros()));
    subscribe(Channels.STATE, settings.get().staleAfter(), this::onState);
    subscribe(Channels.MANUAL_STATE, this::onManual);
    subscribe(Channels.FENCE, avoidance::see);
    subscribe(Channels.ARMING_STATE, ground::heed);
    subscribe(Channels.ACTUATORS, releases::see);
    FirstFailsafe first = new FirstFailsafe(this, context);
    subscribe(
        Channels.FAILSAFE,
        state -> {
          if (first.isOfThisRun(state)) {
            react(state);
          }
        });
  }

  /** Whether it can neither stop nor turn in place; a car with Ackermann steering can stop. */
  private boolean isAeroplane() {
    return lines().turns().accelerationMps2() > 0.0 && settings.get().loiterRadius() > 0.0;
  }

  /** Configured settings, except that a landing's glide path is always linear. */
  final LineSettings lines() {
    PlanningVariables configured = settings.get();
    return orders.failsafe() == FailsafeAction.LAND
        ? configured.lines(AltitudeProfile.LINEAR)
        : configured.lines();
  }

  @Override
  protected final void handOver(HandOver state) {
    orders.handOver(state);
    goal.ifPresent(pursued -> state.message("GOAL", pursued));
    reports.handOver(state);
    holdAt.ifPresent(place -> place.handOver(state, "HOLD AT"));
    state.text("FORESEEN", foreseen);
    goal.flatMap(states::forGoal).ifPresent(planner -> planner.handOver(state));
    end.handOver(state);
    ground.handOver(state);
  }

  @Override
  protected final void takeOver(HandOver state) {
    ground.takeOver(state, state.isFresh(nowS()));
    if (!state.isFresh(nowS())) {
      interrupted = Optional.of(state); // the goals arrive again
      return;
    }
    orders.takeOver(state);
    reports.takeOver(state);
    holdAt = Place.takenOver(state, "HOLD AT");
    foreseen = state.text("FORESEEN").orElse("");
    goal = state.message("GOAL", GoalInformation.class);
    if (goal.flatMap(states::forGoal).filter(planner -> planner.takeOver(state)).isEmpty()) {
      foreseen = goal.map(GoalInformation::uid).orElse(foreseen); // re-enter the same goal
      goal = Optional.empty();
    }
    end.takeOver(state);
    orders.goals().ifPresent(ground::heedGoals);
  }

  @Override
  protected final void configurationChanged(Set<String> variableNames) {
    registerSubscriber(Channels.STATE, settings.get().staleAfter());
    end.leave(); // start a circle with the new radius
  }

  private void onGoals(GoalList list) {
    boolean held = orders.isHolding();
    if (!orders.heed(list, clock().micros())) {
      return;
    }
    ground.heedGoals(list);
    terrainLimits
        .flatMap(limits -> limits.see(list))
        .ifPresent(request -> publish(Channels.MISSION, request));
    if (orders.isHolding() != held) {
      log(list.paused() ? "mission paused" : "mission continues");
      changeHolding();
    }
    if (goal.isPresent() && reports.areOf(goal.get().uid())) {
      goal = Optional.empty(); // if listed again, it must be reached again
    }
  }

  private void onMission(U2SAData message) {
    if (message instanceof MissionReport mission) {
      terrainLimits.ifPresent(limits -> limits.see(mission));
    }
  }

  /**
   * Processes objects of the world model. Without a State Estimator, objects in the vehicle's own
   * axes suffice for a goal that is relative to them, and lists without any such objects for its
   * search: the vehicle is at their origin (thesis 4.3.2). Any other goal, a holding position or a
   * failsafe requires the vehicle's position; without it no navigation points are published.
   */
  private void onObjects(ObjectList list) {
    long now = clock().micros();
    avoidance.world().see(list, now);
    boolean stateless =
        stateMicros == Long.MIN_VALUE
            || now - stateMicros > Clock.micros(settings.get().staleAfter());
    if (stateless && needsNoState() && list.timestamp().isPresent()) {
      StateInformation origin = new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED);
      origin.x(0.0).y(0.0).z(0.0).psi(0.0).timestamp(list.timestamp().getAsLong());
      plan(origin, true);
    }
  }

  /** Whether a current goal can be pursued without a state, and there is no other task. */
  private boolean needsNoState() {
    return orders.failsafe() == FailsafeAction.CONTINUE
        && !orders.isHolding()
        && orders.goals().stream()
            .flatMap(list -> list.goals().stream())
            .anyMatch(this::needsNoState);
  }

  private boolean needsNoState(GoalInformation option) {
    return states.forGoal(option).filter(PlannerState::needsNoState).isPresent();
  }

  private void onState(StateInformation state) {
    stateMicros = clock().micros();
    if (Vehicle.of(state).isPresent()) {
      Vehicle vehicle = Vehicle.of(state).get();
      avoidance.see(vehicle, state);
      terrainLimits.ifPresent(limits -> limits.see(vehicle.place()));
      plan(state, false);
    } else {
      remarks.complain(
          "no plan from a state without x, y or psi, or in BODY: " + state, "state incomplete");
    }
  }

  private void onManual(ManualState state) {
    if (orders.isByHand() && !state.active()) {
      reports.forget();
      forgetPlaces();
    }
    orders.heed(state);
    if (orders.isByHand()) {
      ground.flownByHand();
    }
  }

  /**
   * A vehicle driven by hand holds where it is left, not where it held before; also for a Control
   * that restarts and obeys before this planner hears of the drive's end.
   */
  private void forgetPlaces() {
    holdAt = Optional.empty();
    end.leave();
    checks.leavePlace();
  }

  private void react(FailsafeState state) {
    boolean held = orders.isHolding();
    if (!orders.heed(state, clock().micros())) {
      return;
    }
    log(LogLevelEnum.WARN, "failsafe " + state.action());
    if (orders.isHolding() != held) {
      changeHolding();
    }
  }

  /** Starts holding the current position, or resumes the goal from here. */
  private void changeHolding() {
    if (orders.isHolding()) {
      foreseen = goal.map(GoalInformation::uid).orElse(foreseen);
      goal = Optional.empty();
      reports.forget();
    }
    end.leave();
    checks.leavePlace();
  }

  private void plan(StateInformation state, boolean stateless) {
    if (!orders.isTasked()) {
      return;
    }
    avoidance.world().onlyFromVehicle(stateless);
    try {
      publish(next(state, stateless), state);
    } catch (IllegalArgumentException e) {
      remarks.refuse(e.getMessage() + ": no navigation points");
    }
    boolean isOfGoal = goal.flatMap(states::forGoal).filter(PlannerState::isNews).isPresent();
    if (ground.isNews() || isOfGoal) {
      remember();
    }
  }

  private List<NavigationPoint> next(StateInformation state, boolean stateless) {
    Vehicle.of(state).ifPresent(ground::see);
    if (orders.isByHand()) {
      forgetPlaces();
    }
    if (orders.isHolding()) {
      ground.hold();
      Vehicle vehicle = Vehicle.of(state).orElseThrow();
      return ground.stays() ? ground.points(vehicle) : hold(state, Optional.empty());
    }
    if (ground.isBack()) {
      remarks.complain("returning: already on the ground", "on the ground");
      ground.hold();
      return ground.points(Vehicle.of(state).orElseThrow());
    }
    boolean stands = blind.stands(orders.failsafe(), clock().micros());
    Optional<GoalInformation> chosen = choose(state, stateless);
    if (chosen.isEmpty()) {
      return atEnd(state);
    }
    if (stateless && !needsNoState(chosen.get())) {
      return List.of();
    }
    return stands ? standing(state) : pursue(chosen.get(), state, stateless);
  }

  /** Stops a vehicle whose surroundings are unknown, or circles if it cannot stop. */
  private List<NavigationPoint> standing(StateInformation state) {
    if (!avoidance.world().age().isKnown()) {
      return List.of(); // the vehicle has not moved yet and must not take off
    }
    if (ground.hasLanded()) {
      return ground.points(Vehicle.of(state).orElseThrow());
    }
    return blind.brakes()
        ? List.of(NavigationPoint.at(Point.of(1.0, 0.0, 0.0)).speed(0.0))
        : hold(state, Optional.empty());
  }

  private List<NavigationPoint> hold(StateInformation state, Optional<Place> place) {
    Vehicle vehicle = Vehicle.of(state).orElseThrow();
    List<NavigationPoint> points =
        climb(Optional.empty(), vehicle)
            .map(List::of)
            .orElseGet(() -> end.plan(vehicle, state, place));
    avoidance.news().ifPresent(path -> show(path, state));
    return checks.hovering(points, state);
  }

  private Optional<NavigationPoint> climb(Optional<GoalInformation> to, Vehicle vehicle) {
    return ground.climb(to, vehicle, lines().lookAheadM(vehicle.speedMps()));
  }

  private Optional<GoalInformation> choose(StateInformation state, boolean stateless) {
    String preferred =
        goal.map(GoalInformation::uid).filter(uid -> !reports.areOf(uid)).orElse(foreseen);
    return new GoalChoice(orders.goals().get())
        .goal(preferred, option -> distanceM(option, state, stateless));
  }

  /** Time for which the mission has been pursued [s]. */
  private double missionS() {
    return orders.missionS(clock().micros());
  }

  private double distanceM(GoalInformation option, StateInformation state, boolean stateless) {
    return states
        .forGoal(option)
        .filter(known -> !stateless || known.needsNoState())
        .map(known -> known.distanceM(option, state))
        .orElse(Double.POSITIVE_INFINITY);
  }

  private GoalInformation following(GoalInformation option, StateInformation state) {
    return WaypointAccuracy.following(option, state, settings.get().thresholdSigmas());
  }

  private List<NavigationPoint> pursue(
      GoalInformation choice, StateInformation state, boolean stateless) {
    GoalInformation followed = following(choice, state);
    GoalInformation chosen =
        Vehicle.of(state).map(vehicle -> ground.raised(followed, vehicle)).orElse(followed);
    Optional<PlannerState> planner = states.forGoal(chosen);
    if (planner.isEmpty()) {
      remarks.complain(
          PlannerRemarks.named(chosen)
              + " is a "
              + chosen.typeChain()
              + ": no planner state for that",
          chosen.uid());
      return atEnd(state);
    }
    end.leave();
    checks.leavePlace();
    holdAt = Optional.empty();
    time.see(state.timestamp().orElseThrow(), ground.isArmed());
    Optional<GoalInformation> after =
        new GoalChoice(orders.goals().get())
            .after(choice, foreseen, option -> distanceM(option, state, stateless))
            .map(option -> following(option, state));
    boolean begins = goal.filter(current -> current.uid().equals(chosen.uid())).isEmpty();
    Pursuit pursuit =
        new Pursuit(chosen, begins ? reports.last() : Optional.empty(), after, state, missionS());
    if (begins) {
      log(
          PlannerRemarks.named(chosen)
              + " begins"
              + reports.last().map(done -> ", from \"" + done.uid() + "\"").orElse(""));
      states.substitution(chosen).ifPresent(this::trouble);
      remarks.judgeThreshold(chosen, state);
      planner.get().enter(pursuit);
      interrupted
          .filter(before -> isOf(before, chosen))
          .ifPresent(before -> planner.get().resume(before, pursuit));
      interrupted = Optional.empty();
      checks.begin();
      reports.forget();
    }
    goal = Optional.of(chosen);
    foreseen = after.map(GoalInformation::uid).orElse("");
    Plan next =
        Vehicle.of(state)
            .flatMap(
                vehicle ->
                    ground.rise(chosen, vehicle).or(() -> climb(Optional.of(chosen), vehicle)))
            .map(up -> Plan.underWay(List.of(up)))
            .orElseGet(() -> aside(planner.get().plan(pursuit), chosen, state));
    Plan plan = checked(next, chosen, planner.get().touchesDown(), state);
    ground.lead(chosen, plan, planner.get().touchesDown(), clock().micros());
    if (!plan.remark().isEmpty()) {
      LogLevelEnum level =
          plan.progress() == Plan.Progress.COMPLETED ? LogLevelEnum.INFO : LogLevelEnum.WARN;
      log(level, PlannerRemarks.named(chosen) + " " + plan.remark());
    }
    Vehicle.of(state)
        .map(vehicle -> takeOff.step(chosen, vehicle, ground.isArmed()))
        .filter(remark -> !remark.isEmpty())
        .ifPresent(remark -> trouble(PlannerRemarks.named(chosen) + ": " + remark));
    if (plan.progress() != Plan.Progress.UNDER_WAY) {
      reports.report(chosen, plan, clock().micros());
    }
    avoidance.news().ifPresent(path -> show(path, state));
    rightOfWay.news().ifPresent(path -> show(path, state));
    turnInsideFence(plan.points(), chosen, state);
    List<NavigationPoint> points = view.with(plan.points(), chosen, state);
    remarks.resolved();
    return points;
  }

  /** On the way home, a turning circle may lead over the fence that has stopped the vehicle. */
  private void turnInsideFence(
      List<NavigationPoint> points, GoalInformation to, StateInformation state) {
    Optional<Place> home =
        orders.isReturning() && settings.get().loiterRadius() == 0.0
            ? WaypointState.placeOf(Optional.of(to)).filter(Place::isHorizontal)
            : Optional.<Place>empty();
    Optional<NavigationPoint> own =
        points.stream().filter(point -> point.subsystem().equals("VEHICLE")).findFirst();
    Optional<Vehicle> vehicle = Vehicle.of(state);
    if (own.isPresent() && vehicle.isPresent()) {
      avoidance.turnInsideFence(vehicle.get(), state, own.get(), home);
    }
  }

  /** The step, or an evasion of traffic. */
  private Plan aside(Plan next, GoalInformation to, StateInformation state) {
    boolean stays = to instanceof Station && settings.get().loiterRadius() == 0.0;
    Optional<Place> end =
        stays
            ? WaypointState.placeOf(Optional.of(to)).filter(Place::isHorizontal)
            : Optional.<Place>empty();
    checks.evade(to, () -> distanceM(to, state, false), next.points(), end, state);
    return next;
  }

  /** The step without what is above or below; it gives up a goal that cannot be reached. */
  private Plan checked(Plan next, GoalInformation to, boolean touches, StateInformation state) {
    Optional<String> blocked = checks.guard(to, next.points(), touches, state);
    Optional<String> slow = checks.lackOfHeadway(to, next.points(), state);
    Optional<String> why = blocked.or(() -> slow.filter(reason -> !orders.isReturning()));
    boolean goesOn = next.progress() == Plan.Progress.UNDER_WAY;
    return goesOn && why.isPresent() ? Plan.unless(why, next.points()) : next;
  }

  private static boolean isOf(HandOver before, GoalInformation chosen) {
    return before
        .message("GOAL", GoalInformation.class)
        .filter(goal -> goal.uid().equals(chosen.uid()) && goal.getClass() == chosen.getClass())
        .isPresent();
  }

  private void show(PlannedPath path, StateInformation state) {
    state.timestamp().ifPresent(path::timestamp);
    terrainLimits.ifPresent(limits -> limits.see(path));
    publish(Channels.PLANS, path);
  }

  private List<NavigationPoint> atEnd(StateInformation state) {
    if (reports.last().isPresent()) {
      // the path to an abandoned goal may be obstructed: hold here
      holdAt = WaypointState.placeOf(reports.last().filter(done -> !done.abandoned()));
      reports.forget(); // the next leg does not start at that position
    }
    goal = Optional.empty();
    ground.hold();
    Vehicle vehicle = Vehicle.of(state).orElseThrow();
    if (ground.stays()) {
      return ground.points(vehicle);
    }
    boolean holds = orders.failsafe() == FailsafeAction.RETURN || settings.get().holdsAtEnd();
    if (holdAt.isPresent() && isTaken(holdAt.get(), vehicle, state)) {
      holdAt = Optional.empty(); // it holds here
      end.leave();
    }
    return holds ? hold(state, holdAt) : checks.hovering(List.of(), state);
  }

  /** Whether a vehicle on a surface would come to something on its way to where it holds. */
  private boolean isTaken(Place place, Vehicle vehicle, StateInformation state) {
    return settings.get().loiterRadius() == 0.0
        && place.isHorizontal()
        && !detour.isOfAircraftThatStops(state)
        && detour.isReturnBlocked(vehicle, state, place);
  }

  private void publish(List<NavigationPoint> points, StateInformation state) {
    for (NavigationPoint point : points) {
      point.timestamp(state.timestamp().orElseThrow());
      publish(Channels.NAVIGATION, point);
    }
  }
}
