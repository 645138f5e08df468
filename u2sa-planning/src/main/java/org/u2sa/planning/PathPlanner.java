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
import org.u2sa.messages.goal.Landing;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.goal.TakeOff;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.planning.avoidance.Avoidance;
import org.u2sa.planning.avoidance.AvoidanceVariables;
import org.u2sa.planning.avoidance.KnownGround;
import org.u2sa.planning.guidance.ChosenGuidance;
import org.u2sa.planning.guidance.HeadwayWatch;
import org.u2sa.planning.guidance.LineSettings;
import org.u2sa.planning.guidance.LineSettings.AltitudeProfile;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.guidance.ViewPoints;
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
 * goals. In: state, goals, failsafe, manual-state, fence, actuators. Out: navigation, goal-reports.
 *
 * <p>It plans once per state estimate, so without fresh states it publishes no navigation points.
 * On request of a failsafe it holds its position, as at the mission's end, or publishes none. The
 * same class serves aircraft and ground vehicles; only their configuration differs (thesis
 * 4.6.2.3).
 */
public class PathPlanner extends EventDrivenService {
  private static final long CLOCKS_APART_MICROS = Clock.MICROS_PER_SECOND; // at most

  private final Settings<PlanningVariables> settings = settings(PlanningVariables.class);
  private final PlannerStates states;
  private final EndOfMission end;
  private final GroundStay ground;
  private final Avoidance avoidance;
  private final RightOfWayWatch rightOfWay;
  private final BlindStand blind;
  private final HoverPlace hover;
  private final HeadwayWatch headway = new HeadwayWatch(this::tell, this::remark);
  private final Settings<FlightVariables> flight;
  private final GoalReports reports;
  private final MissionTime time = new MissionTime();
  private final ViewPoints view = new ViewPoints(settings(ViewPoints.Variables.class));
  private Optional<GoalList> goals = Optional.empty();
  // Goal list transferred by the predecessor; it arrives again because it is retained.
  private Optional<GoalList> takenOver = Optional.empty();
  private Optional<GoalInformation> goal = Optional.empty(); // goal being pursued
  private Optional<Place> holdAt = Optional.empty(); // last goal position reached or abandoned
  private FailsafeAction failsafe = FailsafeAction.CONTINUE;
  private boolean hasFailsafe; // whether one was heard
  private long failsafeMicros; // when the present one began
  private boolean byHand; // navigation is currently ignored
  private String foreseen = ""; // UID of the goal expected next
  private long stateMicros = Long.MIN_VALUE; // arrival of the last state
  private String complaint = ""; // last one logged, to log it once
  private String threshold = ""; // last remark on the current goal's threshold

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
    avoidance = new Avoidance(this, seeing, this::lines, this::say, terrain);
    rightOfWay =
        new RightOfWayWatch(
            settings(RightOfWayVariables.class),
            seeing,
            this::lines,
            avoidance.world(),
            this::say,
            this::remark);
    hover = new HoverPlace(avoidance);
    blind = new BlindStand(this, avoidance, () -> avoidance.isOn() || rightOfWay.isOn(), seeing);
    reports =
        new GoalReports(
            report -> publish(Channels.GOAL_REPORTS, report),
            () -> settings.get().reportIntervalMicros());
    Detour detour = new Detour(avoidance);
    flight = settings(FlightVariables.class);
    StationCircle circle =
        new StationCircle(detour, this::lines, () -> settings.get().loiterRadius(), flight);
    PayloadReleases releases = new PayloadReleases();
    states =
        new PlannerStates(
            List.of(
                new WaypointState(guidance, settings, avoidance, rightOfWay, seeing),
                new ObjectGoalState(avoidance, seeing),
                new StationState(
                    guidance,
                    settings(StationVariables.class),
                    circle,
                    detour,
                    () -> seeing.get().drifts()),
                new SearchAreaState(
                    avoidance, guidance, survey, seeing, this::lines, new SurveyHeights(terrain)),
                new TakeOffState(this::lines, flight),
                new LandingState(detour, this::lines, circle, flight),
                new PayloadDropState(detour, this::lines, flight, releases)));
    states.discover(this, new PlannerSurroundings(avoidance, this::missionS));
    ground = new GroundStay(flight, this::isAeroplane);
    end = new EndOfMission(settings, this::lines, guidance, ground::raised);
    registerPublisher(Channels.NAVIGATION);
    registerPublisher(Channels.GOAL_REPORTS);
    registerPublisher(Channels.PLANS);
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
    return failsafe == FailsafeAction.LAND
        ? configured.lines(AltitudeProfile.LINEAR)
        : configured.lines();
  }

  @Override
  protected final void handOver(HandOver state) {
    goals.ifPresent(list -> state.message("GOALS", list));
    goal.ifPresent(pursued -> state.message("GOAL", pursued));
    reports.handOver(state);
    holdAt.ifPresent(place -> place.handOver(state, "HOLD AT"));
    time.handOver(state);
    state.text("FORESEEN", foreseen);
    goal.flatMap(states::forGoal).ifPresent(planner -> planner.handOver(state));
    end.handOver(state);
    state.text("FAILSAFE", failsafe.name());
    ground.handOver(state);
  }

  @Override
  protected final void takeOver(HandOver state) {
    ground.takeOver(state);
    if (!state.isFresh(nowS())) {
      return; // the goals arrive again
    }
    goals = state.message("GOALS", GoalList.class);
    takenOver = goals;
    reports.takeOver(state);
    time.takeOver(state);
    holdAt = Place.takenOver(state, "HOLD AT");
    foreseen = state.text("FORESEEN").orElse("");
    goal = state.message("GOAL", GoalInformation.class);
    if (goal.flatMap(states::forGoal).filter(planner -> planner.takeOver(state)).isEmpty()) {
      foreseen = goal.map(GoalInformation::uid).orElse(foreseen); // re-enter the same goal
      goal = Optional.empty();
    }
    end.takeOver(state);
    goals.ifPresent(ground::heedGoals);
    failsafe = state.text("FAILSAFE").map(FailsafeAction::valueOf).orElse(FailsafeAction.CONTINUE);
  }

  @Override
  protected final void configurationChanged(Set<String> variableNames) {
    registerSubscriber(Channels.STATE, settings.get().staleAfter());
    end.leave(); // start a circle with the new radius
  }

  private void onGoals(GoalList list) {
    boolean known = takenOver.filter(list::equals).isPresent();
    takenOver = Optional.empty();
    if (known) {
      return; // retained, and already handled by the previous planner
    }
    boolean held = isHolding();
    goals = Optional.of(list);
    ground.heedGoals(list);
    if (isHolding() != held) {
      log(list.paused() ? "mission paused" : "mission continues");
      changeHolding();
    }
    time.update(list, clock().micros());
    if (goal.isPresent() && reports.areOf(goal.get().uid())) {
      goal = Optional.empty(); // if listed again, it must be reached again
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
    return failsafe == FailsafeAction.CONTINUE
        && !isHolding()
        && goals.stream().flatMap(list -> list.goals().stream()).anyMatch(this::needsNoState);
  }

  private boolean needsNoState(GoalInformation option) {
    return states.forGoal(option).filter(PlannerState::needsNoState).isPresent();
  }

  private void onState(StateInformation state) {
    stateMicros = clock().micros();
    if (Vehicle.of(state).isPresent()) {
      avoidance.see(Vehicle.of(state).get());
      plan(state, false);
    } else {
      complain(
          "no plan from a state without x, y or psi, or in BODY: " + state, "state incomplete");
    }
  }

  private void onManual(ManualState state) {
    if (byHand && !state.active()) {
      reports.forget();
      forgetPlaces();
    }
    byHand = state.active();
    if (byHand) {
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
    hover.leave();
  }

  private void react(FailsafeState state) {
    FailsafeAction action = state.action();
    boolean isFirst = !hasFailsafe; // of this planner: the answer may be older
    hasFailsafe = true;
    if (action == failsafe) {
      return;
    }
    failsafeMicros = isFirst ? 0L : state.timestamp().orElse(clock().micros());
    log(LogLevelEnum.WARN, "failsafe " + action);
    boolean held = isHolding();
    failsafe = action;
    if (isHolding() != held) {
      changeHolding();
    }
  }

  private boolean isHolding() {
    return failsafe == FailsafeAction.HOLD
        || goals.filter(GoalList::paused).isPresent()
        || goals.filter(this::leadOnDespiteFailsafe).isPresent();
  }

  /** RETURN and LAND are answered with other goals, unless no Mission Manager runs. */
  private boolean leadOnDespiteFailsafe(GoalList list) {
    boolean isWayBack = failsafe == FailsafeAction.RETURN || failsafe == FailsafeAction.LAND;
    return isWayBack
        && !list.returning()
        && !list.goals().isEmpty()
        && list.timestamp().orElse(Long.MAX_VALUE) < failsafeMicros - CLOCKS_APART_MICROS;
  }

  /** Starts holding the current position, or resumes the goal from here. */
  private void changeHolding() {
    if (isHolding()) {
      foreseen = goal.map(GoalInformation::uid).orElse(foreseen);
      goal = Optional.empty();
      reports.forget();
    }
    end.leave();
    hover.leave();
  }

  private void plan(StateInformation state, boolean stateless) {
    if (failsafe == FailsafeAction.STOP) {
      return;
    }
    if (goals.isEmpty() && !isHolding()) {
      return; // no mission yet, so nothing to hold
    }
    avoidance.world().onlyFromVehicle(stateless);
    try {
      publish(next(state, stateless), state);
    } catch (IllegalArgumentException e) {
      refuse(e.getMessage() + ": no navigation points");
    }
    if (ground.isNews()) {
      remember();
    }
  }

  private List<NavigationPoint> next(StateInformation state, boolean stateless) {
    Vehicle.of(state).ifPresent(ground::see);
    if (byHand) {
      forgetPlaces();
    }
    if (isHolding()) {
      ground.hold();
      Vehicle vehicle = Vehicle.of(state).orElseThrow();
      return ground.stays() ? ground.points(vehicle) : hold(state, Optional.empty());
    }
    if (ground.isBack()) {
      complain("returning: already on the ground", "on the ground");
      ground.hold();
      return ground.points(Vehicle.of(state).orElseThrow());
    }
    boolean stands = blind.stands(failsafe, clock().micros());
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
        climb(Optional.empty(), vehicle).map(List::of).orElseGet(() -> end.plan(vehicle, place));
    return hovering(points, state);
  }

  /** The points at which it holds, or those that evade traffic. */
  private List<NavigationPoint> hovering(List<NavigationPoint> held, StateInformation state) {
    if (isFlown()) {
      Vehicle vehicle = Vehicle.of(state).orElseThrow();
      own(held).ifPresent(point -> avoidance.hover(vehicle, state, point));
    }
    List<NavigationPoint> points = held.isEmpty() && isFlown() ? hover.points(state) : held;
    KnownGround below = new KnownGround(ground.stoodAt(), false, false);
    guard("", points, below, state); // it waits at its altitude
    withoutHeadway(points, state);
    return points;
  }

  private Optional<NavigationPoint> climb(Optional<GoalInformation> to, Vehicle vehicle) {
    return ground.climb(to, vehicle, lines().lookAheadM(vehicle.speedMps()));
  }

  private Optional<GoalInformation> choose(StateInformation state, boolean stateless) {
    String preferred =
        goal.map(GoalInformation::uid).filter(uid -> !reports.areOf(uid)).orElse(foreseen);
    return new GoalChoice(goals.get())
        .goal(preferred, option -> distanceM(option, state, stateless));
  }

  /** Time for which the mission has been pursued [s]. */
  private double missionS() {
    return time.elapsedS(clock().micros());
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

  /** Warns at the start of a goal if the state is too inaccurate for its threshold. */
  private void judgeThreshold(GoalInformation begun, StateInformation state) {
    String said = WaypointAccuracy.remark(begun, state).orElse("");
    if (threshold.isEmpty() && !said.isEmpty()) {
      trouble(said); // once; the remark covers the others
    }
    threshold = said;
    remark("threshold", said);
  }

  private List<NavigationPoint> pursue(
      GoalInformation choice, StateInformation state, boolean stateless) {
    GoalInformation followed = following(choice, state);
    GoalInformation chosen =
        Vehicle.of(state).map(vehicle -> ground.raised(followed, vehicle)).orElse(followed);
    Optional<PlannerState> planner = states.forGoal(chosen);
    if (planner.isEmpty()) {
      complain(
          named(chosen) + " is a " + chosen.typeChain() + ": no planner state for that",
          chosen.uid());
      return atEnd(state);
    }
    end.leave();
    hover.leave();
    holdAt = Optional.empty();
    Optional<GoalInformation> after =
        new GoalChoice(goals.get())
            .after(choice, foreseen, option -> distanceM(option, state, stateless))
            .map(option -> following(option, state));
    boolean begins = goal.filter(current -> current.uid().equals(chosen.uid())).isEmpty();
    Pursuit pursuit =
        new Pursuit(chosen, begins ? reports.last() : Optional.empty(), after, state, missionS());
    if (begins) {
      log(
          named(chosen)
              + " begins"
              + reports.last().map(done -> ", from \"" + done.uid() + "\"").orElse(""));
      states.substitution(chosen).ifPresent(this::trouble);
      judgeThreshold(chosen, state);
      planner.get().enter(pursuit);
      headway.begin();
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
    Plan safe = guarded(next, chosen, planner.get().touchesDown(), state);
    Plan plan = advancing(safe, chosen, state);
    ground.lead(chosen, plan, planner.get().touchesDown(), clock().micros());
    if (!plan.remark().isEmpty()) {
      LogLevelEnum level =
          plan.progress() == Plan.Progress.COMPLETED ? LogLevelEnum.INFO : LogLevelEnum.WARN;
      log(level, named(chosen) + " " + plan.remark());
    }
    if (plan.progress() != Plan.Progress.UNDER_WAY) {
      reports.report(chosen, plan, clock().micros());
    }
    avoidance.news().ifPresent(path -> show(path, state));
    rightOfWay.news().ifPresent(path -> show(path, state));
    List<NavigationPoint> points = view.with(plan.points(), chosen, state);
    complaint = "";
    return points;
  }

  /** The step without climbing or descending into what is above or below. */
  private Plan guarded(Plan next, GoalInformation to, boolean touches, StateInformation state) {
    KnownGround below =
        to instanceof Landing landing
            ? new KnownGround(Optional.of(Place.of(landing)), true, touches)
            : new KnownGround(ground.stoodAt(), false, false);
    Optional<String> why = guard(to.uid(), next.points(), below, state);
    if (to instanceof Landing landing && avoidance.isHeldUp()) {
      Place over = Place.of(landing).at(Vehicle.of(state).orElseThrow().place().upM().orElse(0.0));
      evade(next, Optional.of(over), state); // it hovers above the position
    }
    boolean goesOn = next.progress() == Plan.Progress.UNDER_WAY;
    return goesOn && why.isPresent() ? Plan.unless(why, next.points()) : next;
  }

  /** The step, unless the aeroplane makes no headway, as in a wind that is faster. */
  private Plan advancing(Plan next, GoalInformation to, StateInformation state) {
    if (to instanceof TakeOff) {
      headway.leave();
      return next;
    }
    Optional<String> why = withoutHeadway(next.points(), state);
    boolean goesOn = next.progress() == Plan.Progress.UNDER_WAY;
    return goesOn && why.isPresent() && !goals.get().returning()
        ? Plan.unless(why, next.points())
        : next;
  }

  private Optional<String> withoutHeadway(List<NavigationPoint> points, StateInformation state) {
    Optional<NavigationPoint> point = own(points);
    if (point.isEmpty() || !isAeroplane() || !isFlown()) {
      headway.leave();
      return Optional.empty();
    }
    Vehicle vehicle = Vehicle.of(state).orElseThrow();
    return headway.step(vehicle, state, point.get().point(), flight.get().headwayTime());
  }

  /**
   * The step, or an evasion of traffic unless it leads straight up or down from or to the ground.
   */
  private Plan aside(Plan next, GoalInformation to, StateInformation state) {
    boolean isOverGround =
        to instanceof TakeOff
            || to instanceof Landing && distanceM(to, state, false) < KnownGround.REACH_M;
    boolean staysAt = to instanceof Station && settings.get().loiterRadius() == 0.0;
    Optional<Place> end =
        staysAt
            ? WaypointState.placeOf(Optional.of(to)).filter(Place::isHorizontal)
            : Optional.<Place>empty();
    if (!isOverGround) {
      evade(next, end, state);
    }
    return next;
  }

  private void evade(Plan next, Optional<Place> end, StateInformation state) {
    if (isFlown()) {
      Vehicle vehicle = Vehicle.of(state).orElseThrow();
      own(next.points()).ifPresent(point -> avoidance.evade(vehicle, state, point, end));
    }
  }

  private static Optional<NavigationPoint> own(List<NavigationPoint> points) {
    return points.stream().filter(PathPlanner::isOwn).findFirst();
  }

  private static boolean isOwn(NavigationPoint point) {
    return point.subsystem().equals("VEHICLE");
  }

  private boolean isFlown() {
    return ground.flies() && !byHand;
  }

  private Optional<String> guard(
      String uid, List<NavigationPoint> points, KnownGround below, StateInformation state) {
    Vehicle vehicle = Vehicle.of(state).orElseThrow();
    return own(points).flatMap(point -> avoidance.guard(uid, vehicle, state, point, below));
  }

  private void show(PlannedPath path, StateInformation state) {
    state.timestamp().ifPresent(path::timestamp);
    publish(Channels.PLANS, path);
  }

  private static String named(GoalInformation goal) {
    return "goal \"" + goal.uid() + "\"";
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
    boolean holds = failsafe == FailsafeAction.RETURN || settings.get().holdsAtEnd();
    return holds ? hold(state, holdAt) : hovering(List.of(), state);
  }

  private void publish(List<NavigationPoint> points, StateInformation state) {
    for (NavigationPoint point : points) {
      point.timestamp(state.timestamp().orElseThrow());
      publish(Channels.NAVIGATION, point);
    }
  }

  private void tell(String what) {
    trouble(goal.map(pursued -> named(pursued) + ": ").orElse("") + what);
  }

  private void say(String what, boolean isTrouble) {
    String line = "goal \"" + goal.map(GoalInformation::uid).orElse("") + "\": " + what;
    if (isTrouble) {
      trouble(line); // also reported in health
    } else {
      log(LogLevelEnum.WARN, line);
    }
  }

  /** Reports that the current goal cannot be planned: once, also in health. */
  private void refuse(String what) {
    String key = "no plan for " + goal.map(GoalInformation::uid).orElse("the end");
    if (!complaint.equals(key)) {
      trouble(what);
      complaint = key;
    }
  }

  /** Logs a problem once until it is resolved. */
  private void complain(String what, String key) {
    if (!complaint.equals(key)) {
      log(LogLevelEnum.WARN, what);
      complaint = key;
    }
  }
}
