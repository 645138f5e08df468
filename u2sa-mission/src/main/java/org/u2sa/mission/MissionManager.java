package org.u2sa.mission;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.mission.MissionRequest;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.mission.returning.HomeCheck;
import org.u2sa.mission.returning.ReturnPlaces;
import org.u2sa.service.FirstFailsafe;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.handover.HandOver;

/**
 * Manages the mission's goals and publishes the current ones (thesis 3.2.3.2). In: goal-reports,
 * goal-updates, goal-commands, mission, failsafe, arming-state, manual-state, and fence and state
 * for the place to return to. Out: goals, at the start, on every change, and in answer to a report
 * on a goal that is not current; mission, in answer to requests and orders.
 *
 * <p>A mission's home is a goal too, named "home". An empty list means that the mission is over.
 * The failsafes RETURN and LAND have their own goals; afterwards the mission resumes at the
 * interrupted goal. After a restart in the same run it resumes too, unless the mission file has
 * changed.
 */
public final class MissionManager extends PeriodicService {
  /**
   * Defaults for values omitted in a mission. Required, because an aircraft's tolerance differs
   * from a rover's.
   *
   * @param defaultThreshold default horizontal threshold of waypoints [m]
   */
  public record Defaults(
      @Variable(unit = "m", min = 0, minExcluded = true)
          @Description("Default horizontal threshold of waypoints.")
          double defaultThreshold) {}

  private static final String NAME = "MissionManager";
  private static final String DIGEST = "MISSION DIGEST"; // in the hand-over
  private static final long MANUAL_NEWS_MICROS =
      5 * Clock.MICROS_PER_SECOND; // older: from another run
  private static final double LIMITS_CHECKED_HZ = 5.0;
  private static final int MAX_WAITED = 3; // repetitions, one a second

  private final Settings<MissionVariables> settings = settings(MissionVariables.class);
  private final Settings<Defaults> defaults = settings(Defaults.class);
  private final FirstFailsafe firstFailsafe;
  private final FailsafeMissions failsafes;
  private final MissionFiles files;
  private final MissionOrders orders;
  private final MissionRun run = new MissionRun(clock(), this::thresholdM);
  private final TimeLimits limits = new TimeLimits(run, this);
  private final GoalMessages messages =
      new GoalMessages(
          run,
          this,
          this::lateness,
          this::passTime,
          this::publishGoals,
          () -> publish(Channels.GOALS, goalList()));
  private final DrivingByHand byHand;
  private final Resumable resumable;
  private final MessageTypes messageTypes;
  private final ReturnPlaces returnPlaces = new ReturnPlaces(() -> this.home);
  private final HomeCheck homeCheck = new HomeCheck();
  private Optional<Waypoint> home = Optional.empty();
  private boolean beginsAnew = true; // false after a takeover
  private boolean isStateLost; // restarted without the saved state, as after a full disk
  private int waited; // failsafes for a position, after a restart

  /**
   * Launcher constructor.
   *
   * @throws org.u2sa.interfaces.BadInputException if the mission file is invalid
   */
  public MissionManager(ServiceContext context) {
    super(context, ServiceRole.MISSION_MANAGER, NAME, LIMITS_CHECKED_HZ);
    files = new MissionFiles(context);
    run.progress(new MissionProgress(load()));
    failsafes = new FailsafeMissions(run, files, settings, this);
    resumable =
        new Resumable(
            run,
            new SavedMission(context, NAME, MissionManager.class.getName()),
            files::digest,
            settings,
            this);
    firstFailsafe = new FirstFailsafe(this, context);
    byHand = new DrivingByHand(context.isRestart() || context.isSwap());
    isStateLost = context.isRestart();
    messageTypes = context.messageTypes();
    orders =
        new MissionOrders(
            run,
            resumable,
            messageTypes,
            this,
            failsafes::landGoals,
            () -> returnPlaces.nearest(thresholdM()),
            returnPlaces::wayTo,
            this::replace,
            this::lateness);
    registerPublisher(Channels.GOALS);
    registerPublisher(Channels.MISSION);
    subscribe(Channels.GOAL_REPORTS, this::onReport);
    subscribe(Channels.GOAL_UPDATES, messages::update);
    subscribe(Channels.GOAL_COMMANDS, messages::changeTo);
    subscribe(Channels.MISSION, this::onMission);
    // Before failsafes: after a restart, the retained fence must be known when RETURN arrives.
    subscribe(Channels.FENCE, returnPlaces::see);
    subscribe(Channels.STATE, this::onState);
    subscribe(Channels.FAILSAFE, this::onFailsafe);
    subscribe(Channels.ARMING_STATE, this::onArming);
    subscribe(Channels.MANUAL_STATE, this::onManual);
  }

  /** Rejects an unreadable mission before it replaces a readable one. */
  @Override
  protected Optional<String> configurationRefusal(Map<String, Object> values) {
    return files.refusal(values, this);
  }

  private GoalSequence load() {
    Mission mission = files.load(MissionVariables.MISSION, thresholdM());
    home = Optional.empty();
    return sequence(mission);
  }

  /** Prepares a mission; without a home of its own it keeps the present one. */
  private GoalSequence sequence(Mission mission) {
    run.mission(mission);
    log("mission " + mission.origin() + " with goals " + MissionRun.names(mission.goals()));
    mission.warnings().forEach(warning -> log(LogLevelEnum.WARN, warning));
    GoalSequence loaded =
        new GoalSequence(mission.goals(), settings.get().loop(), settings.get().options());
    home = mission.home().map(place -> place.waypoint(Home.NAME, thresholdM())).or(() -> home);
    if (home.isPresent() && !loaded.knows(Home.NAME)) {
      loaded.update(home.get());
    }
    return loaded;
  }

  private double thresholdM() {
    return defaults.get().defaultThreshold();
  }

  @Override
  protected void configurationChanged(Set<String> variableNames) {
    if (variableNames.contains(MissionVariables.MISSION)
        || variableNames.contains(MissionVariables.DEFAULT_THRESHOLD)) {
      startMission();
    }
    if (FailsafeMissions.areConfiguredBy(variableNames)) {
      loadFailsafes();
    }
    if (variableNames.contains("LOOP") || variableNames.contains("OPTIONS")) {
      run.progress().rules(settings.get().loop(), settings.get().options());
      publishGoals();
    }
  }

  private void loadFailsafes() {
    try {
      failsafes.load();
    } catch (BadInputException e) {
      log(LogLevelEnum.ERROR, e.getMessage() + ": failsafe missions unchanged");
    }
  }

  private void replace(Mission mission) {
    passTime();
    begin(sequence(mission));
    resumable.leaveFile();
  }

  private void begin(GoalSequence mission) {
    run.progress().begin(mission);
    messages.beginMission();
  }

  private void startMission() {
    try {
      begin(load());
      resumable.forgetOther();
    } catch (BadInputException e) {
      log(LogLevelEnum.ERROR, e.getMessage() + ": mission unchanged");
      return;
    }
    publishGoals();
  }

  @Override
  protected void handOver(HandOver state) {
    state.text(MissionVariables.MISSION, settings.get().mission());
    state.text(DIGEST, files.digest());
    state.number(MissionVariables.DEFAULT_THRESHOLD, thresholdM());
    limits.handOver(state);
    byHand.handOver(state);
    orders.handOver(state);
    messages.handOver(state);
    run.progress().handOver(state);
  }

  @Override
  protected void takeOver(HandOver state) {
    isStateLost = false;
    byHand.takeOver(state);
    orders.takeOver(state);
    messages.takeOver(state);
    boolean isItsFile =
        state.text(MissionVariables.MISSION).filter(settings.get().mission()::equals).isPresent();
    // a re-executed recording has a copy elsewhere
    boolean same =
        (isItsFile || state.text(DIGEST).filter(files.digest()::equals).isPresent())
            && state.number(MissionVariables.DEFAULT_THRESHOLD).orElse(0.0) == thresholdM();
    if (!same) {
      log(LogLevelEnum.WARN, "mission changed since the last run: starting it from its first goal");
      run.progress().pause(state.flag(MissionProgress.PAUSED));
      return;
    }
    MissionProgress.takenOver(state, settings.get().loop(), settings.get().options())
        .ifPresent(
            taken -> {
              run.progress(taken);
              limits.takeOver(state);
              beginsAnew = false;
            });
  }

  @Override
  protected void begin() {
    if (beginsAnew) {
      resumable.atStart().ifPresent(run::progress);
    }
    if (isStateLost && !run.progress().mission().isOver()) {
      run.progress().pause(true);
      trouble("restarted without a saved state: paused, as the mission may have been");
    }
    passTime(); // between two Mission Managers, too
    publishGoals();
  }

  @Override
  protected void step(double nowS) {
    passTime();
  }

  private void onArming(ArmingState state) {
    passTime(); // first, under the previous conditions
    boolean stood = limits.stands();
    if (limits.count(state.armed())) {
      publish(Channels.GOALS, goalList()); // the mission's time resumes here
    }
    if (limits.stands() != stood) {
      remember();
    }
  }

  /** After manual driving, the vehicle holds instead of moving on. */
  private void onManual(ManualState state) {
    boolean isNews = clock().micros() - state.timestamp().orElse(0L) < MANUAL_NEWS_MICROS;
    MissionProgress progress = run.progress();
    boolean isDriven = byHand.see(state, isNews);
    run.drivenBy(byHand.driver());
    if (isDriven && !progress.isPaused() && !progress.mission().isOver()) {
      passTime();
      progress.pause(true);
      log("paused: driven by hand by \"" + state.operator() + "\"");
      publishGoals();
    }
  }

  private void passTime() {
    if (limits.pass()) {
      publishGoals();
    }
  }

  private void onState(StateInformation state) {
    returnPlaces.see(state);
    homeCheck.distance(state, home).ifPresent(warning -> log(LogLevelEnum.WARN, warning));
    if (beginsAnew && !isStateLost) { // otherwise it may hover there
      Optional<Geodetic> level =
          run.mission().home().filter(each -> each.z().isPresent()).flatMap(Home::geodetic);
      homeCheck.altitude(state, level, limits.stands()).ifPresent(this::trouble);
    }
  }

  private void onMission(U2SAData message) {
    passTime();
    if (message instanceof MissionRequest request) {
      if (request.classes()) {
        GoalClasses.of(messageTypes, getServiceName())
            .forEach(each -> publish(Channels.MISSION, each));
      }
      Optional<String> resumableAt = resumable.where().or(() -> run.progress().backTo());
      publish(Channels.MISSION, run.report(request.requestId(), getServiceName(), resumableAt));
    } else if (message instanceof MissionOrder order) {
      publish(Channels.MISSION, orders.obey(order, getServiceName(), this::publishGoals));
    }
  }

  private void onFailsafe(FailsafeState failsafe) {
    if (firstFailsafe.isOfThisRun(failsafe)) {
      react(failsafe.action());
    }
    if (files.haveNews()) { // checked at each repetition
      publishGoals();
    }
  }

  /** Switches to a failsafe's own mission, or back to the interrupted goal. */
  private void react(FailsafeAction action) {
    if (action == run.progress().pursuedFor()) {
      return;
    }
    if (leads(action) && !returnPlaces.isReady() && waited < MAX_WAITED) {
      waited++;
      return; // the next repetition counts
    }
    waited = 0;
    passTime();
    if (run.progress()
        .turnTo(
            action,
            failsafes.sequence(action, returnPlaces.nearest(thresholdM()), returnPlaces::wayTo))) {
      boolean resumes = action == FailsafeAction.CONTINUE;
      log(
          resumes ? LogLevelEnum.INFO : LogLevelEnum.WARN,
          resumes ? "resuming the mission" : "leaving the mission: " + action);
      publishGoals();
    }
  }

  private static boolean leads(FailsafeAction action) {
    return action == FailsafeAction.RETURN || action == FailsafeAction.LAND;
  }

  private void onReport(GoalInformation goal) {
    passTime();
    if (goal.completed() || goal.abandoned()) {
      messages.finish(goal);
    } else {
      unexpected(goal); // already pursued: no consequences
    }
  }

  private void publishGoals() {
    GoalSequence sequence = run.progress().pursued();
    if (sequence.isOver()) {
      log("mission is over: " + run.progress().words());
    } else {
      log(
          (run.progress().isHeld() ? "paused at goals " : "current goals ")
              + MissionRun.names(sequence.current()));
    }
    remember();
    resumable.save(run.progress());
    files.faults().forEach(fault -> log(LogLevelEnum.WARN, fault));
    publish(Channels.GOALS, goalList());
  }

  private GoalList goalList() {
    GoalSequence sequence = run.progress().pursued();
    GoalList list =
        new GoalList()
            .goals(sequence.current())
            .upcoming(sequence.upcoming())
            .landGoals(failsafes.landGoals().size())
            .elapsed(run.progress().elapsedS());
    if (run.progress().isHeld()) {
      list.paused(true);
    }
    if (failsafes.leadBack(sequence.currentNames())) {
      list.returning(true);
    }
    List<String> faults = files.faults();
    return faults.isEmpty() ? list : list.fileFaults(faults);
  }
}
