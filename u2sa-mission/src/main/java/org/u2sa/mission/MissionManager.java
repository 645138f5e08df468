package org.u2sa.mission;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
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
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.GoalResult;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.GoalCommand;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.mission.MissionRequest;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.FirstFailsafe;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.handover.HandOver;
import org.u2sa.service.inbox.ObeyedOrders;

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
  private static final String OBEYED = "OBEYED COMMANDS AND UPDATES";
  private static final double LIMITS_CHECKED_HZ = 5.0;
  private static final long REPEAT_EVERY_MICROS = Clock.MICROS_PER_SECOND;
  private static final int MAX_WAITED = 3; // repetitions, one a second
  private static final long ALWAYS_LOGGED = 100; // later ones at 128, 256, 512…

  private final Settings<MissionVariables> settings = settings(MissionVariables.class);
  private final Settings<Defaults> defaults = settings(Defaults.class);
  private final FirstFailsafe firstFailsafe;
  private final FailsafeMissions failsafes;
  private final MissionFiles files;
  private final MissionOrders orders;
  private final ObeyedOrders obeyed = new ObeyedOrders(); // goal commands and updates
  private final MissionRun run = new MissionRun(clock(), this::thresholdM);
  private final TimeLimits limits = new TimeLimits(run, this);
  private final Map<String, Long> reportedMicros = new HashMap<>(); // latest report by goal
  private final DrivingByHand byHand;
  private final Resumable resumable;
  private final MessageTypes messageTypes;
  private final ReturnPlaces returnPlaces = new ReturnPlaces(() -> this.home);
  private final HomeDistance homeDistance = new HomeDistance();
  private Optional<Waypoint> home = Optional.empty();
  private boolean beginsAnew = true; // false after a takeover
  private boolean isStateLost; // restarted without the saved state, as after a full disk
  private long repeatDueMicros; // of the current goals, for a planner unaware of them
  private long ignored; // reports and updates
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
    subscribe(Channels.GOAL_UPDATES, this::update);
    subscribe(Channels.GOAL_COMMANDS, this::changeTo);
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
    reportedMicros.clear();
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
    state.texts(OBEYED, obeyed.identities());
    run.progress().handOver(state);
  }

  @Override
  protected void takeOver(HandOver state) {
    isStateLost = false;
    byHand.takeOver(state);
    orders.takeOver(state);
    obeyed.takeOver(state.texts(OBEYED));
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
    homeDistance.check(state, home).ifPresent(warning -> log(LogLevelEnum.WARN, warning));
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
      finish(goal);
    } else {
      unexpected(goal); // already pursued: no consequences
    }
  }

  private void finish(GoalInformation goal) {
    String uid = goal.uid();
    GoalResult result = goal.completed() ? GoalResult.DONE : GoalResult.FAILED;
    boolean current = run.progress().pursued().currentNames().contains(uid);
    boolean known = run.progress().pursued().knows(uid); // others' times are not kept
    if (!known
        || isRepeated(goal)
        || !run.progress()
            .finish(uid, result, Optional.of(goal), "abandoned by the planner", run.micros())) {
      String what = current ? "has already arrived" : known ? "is not current" : "is not known";
      ignore("report of goal \"" + uid + "\" ignored: it " + what);
      if (known) {
        repeatGoals();
      }
      return;
    }
    if (goal.completed()) {
      log("goal \"" + uid + "\" completed");
    } else {
      String why = goal.reason().map(text -> ": " + text).orElse("");
      log(LogLevelEnum.WARN, "goal \"" + uid + "\" abandoned by the planner" + why);
    }
    publishGoals();
  }

  /** Logs rejected messages from others, rate-limited. */
  private void ignore(String what) {
    ignored++;
    if (ignored <= ALWAYS_LOGGED || Long.bitCount(ignored) == 1) {
      log(LogLevelEnum.WARN, what + (ignored <= ALWAYS_LOGGED ? "" : " (" + ignored + " so far)"));
    }
  }

  private void update(GoalInformation goal) {
    Optional<String> late = lateness(goal);
    if (late.isPresent()) {
      ignore("update of goal \"" + goal.uid() + "\" refused: " + late.get());
      return;
    }
    if (!obeyed.add("", goal)) {
      ignore("update of goal \"" + goal.uid() + "\" ignored: it has already arrived");
      return;
    }
    GoalSequence updated = run.progress().knowing(goal.uid());
    if (!updated.book.hasRoomForUpdate(goal)) {
      ignore(
          "update of goal \"" + goal.uid() + "\" refused: the goals would be too long to publish");
      return;
    }
    Optional<String> lack = updated.book.lackAfter(goal);
    if (lack.isPresent()) {
      ignore("update of goal \"" + goal.uid() + "\" refused: it " + lack.get());
      return;
    }
    if (updated.update(goal)) {
      log("goal \"" + goal.uid() + "\" updated");
    } else {
      String fate = "it is not pursued until another goal's next names it, or it is commanded";
      log(LogLevelEnum.WARN, "goal \"" + goal.uid() + "\" added; " + fate);
    }
    publishGoals();
  }

  private void changeTo(GoalCommand command) {
    String uid = command.uid();
    Optional<String> late = lateness(command);
    if (late.isPresent()) {
      log(LogLevelEnum.WARN, "command to change to goal \"" + uid + "\" rejected: " + late.get());
      return;
    }
    if (!obeyed.add("", command)) {
      log(LogLevelEnum.WARN, "command to change to goal \"" + uid + "\" ignored: it came twice");
      return;
    }
    if (!run.progress().pursued().knows(uid)) {
      log(LogLevelEnum.WARN, "command to change to goal \"" + uid + "\" rejected: unknown");
      return;
    }
    if (run.objection().isPresent()) {
      log(
          LogLevelEnum.WARN,
          "command to change to goal \"" + uid + "\" rejected: " + run.objection().get());
      return;
    }
    passTime();
    run.progress().changeTo(uid);
    log("changing to goal \"" + uid + "\" on command");
    publishGoals();
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

  /**
   * Repeats the current goals to a planner that pursues another goal and may have missed them.
   * Rate-limited, so that a permanent disagreement does not cause a flood; planners repeat their
   * reports.
   */
  private void repeatGoals() {
    long now = run.micros();
    if (now >= repeatDueMicros) {
      repeatDueMicros = now + REPEAT_EVERY_MICROS;
      publish(Channels.GOALS, goalList());
    }
  }

  /**
   * Whether a report with this goal and time has already arrived: duplicated by the network, or
   * repeated by a planner until answered. In a loop each would count as another lap. False without
   * a time.
   */
  private boolean isRepeated(GoalInformation report) {
    return report.timestamp().isPresent()
        && Objects.equals(
            reportedMicros.put(report.uid(), report.timestamp().getAsLong()),
            report.timestamp().getAsLong());
  }
}
