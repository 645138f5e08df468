package org.u2sa.core.mission;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.LogLevelEnum;
import org.u2sa.interfaces.Range;
import org.u2sa.interfaces.Variable;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.GoalInformation;
import org.u2sa.messages.GoalList;
import org.u2sa.messages.U2SAData;
import org.u2sa.messages.Waypoint;
import org.u2sa.messages.contract.FailsafeAction;
import org.u2sa.messages.contract.FailsafeState;
import org.u2sa.messages.contract.GoalCommand;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/**
 * Keeps the goals of the mission and says which are current (thesis 3.2.3.2). In: goal-reports,
 * goal-updates, goal-commands, failsafe. Out: goals, at the start and at each change.
 *
 * <p>A mission's home is a goal too, named "home", to which nothing but a command leads. A goal
 * that comes in completed or abandoned is a report, any other an update. A list without goals says
 * that the mission is over. A failsafe to return or to land has goals of its own; when it is over,
 * the mission is resumed where it was left.
 */
public final class MissionManager extends EventDrivenService {
  static final Variable<String> MISSION =
      Variable.text("MISSION")
          .describedAs(
              "The mission's XML file, relative to the configuration file. Changed while running: the new mission begins.");

  static final Variable<Boolean> LOOP =
      Variable.flag("LOOP")
          .ifAbsent(false)
          .describedAs(
              "Whether the mission begins anew after its last goal (thesis 4.5.2.3 did for ever).");

  static final Variable<String> OPTIONS =
      Variable.text("OPTIONS")
          .oneOf(GoalSequence.Options.ALL.name(), GoalSequence.Options.ANY.name())
          .ifAbsent(GoalSequence.Options.ALL.name())
          .describedAs(
              "Of several next goals, whether ALL are to be finished before what follows, or ANY one.");

  /** The mission by which it lands; the Safety Manager asks whether there is one. */
  public static final Variable<String> LAND_MISSION = FailsafeMissions.LAND_MISSION;

  static final Variable<Double> DEFAULT_THRESHOLD =
      Variable.number("DEFAULT THRESHOLD", "m")
          .range(Range.positive())
          .ifAbsent(Mission.DEFAULT_THRESHOLD_M)
          .describedAs("Horizontal threshold of waypoints that give none.");

  /** The goal to which a vehicle returns on command. */
  static final String HOME = "home";

  private final FailsafeMissions failsafes;
  private GoalSequence sequence; // the one that is pursued: the mission, or a failsafe's
  private Optional<Waypoint> home = Optional.empty();
  private GoalSequence mission; // where it was left for a failsafe; null while it is pursued
  private FailsafeAction pursuedFor = FailsafeAction.CONTINUE;
  private final Set<String> completed = new LinkedHashSet<>();
  private final Set<String> abandoned = new LinkedHashSet<>();

  /**
   * Called by the launcher.
   *
   * @throws org.u2sa.interfaces.BadInputException if the mission file is wrong
   */
  public MissionManager(ServiceContext context) {
    super(context, ServiceRole.MISSION_MANAGER, "MissionManager");
    sequence = load();
    failsafes = new FailsafeMissions(this, context());
    registerPublisher(Channels.GOALS);
    registerSubscriber(Channels.GOAL_REPORTS);
    registerSubscriber(Channels.GOAL_UPDATES);
    registerSubscriber(Channels.GOAL_COMMANDS);
    registerSubscriber(Channels.FAILSAFE);
  }

  private Mission read(String file, double thresholdM) {
    return Mission.load(
        context().configuration().resolve(file), context().messageTypes(), thresholdM);
  }

  /** Refuses a mission that cannot be read, before it takes the place of one that can. */
  @Override
  protected Optional<String> configurationRefusal(Map<String, Object> values) {
    String file = (String) values.get(MISSION.name());
    double thresholdM = (Double) values.get(DEFAULT_THRESHOLD.name());
    if (file.equals(getVariable(MISSION)) && thresholdM == getVariable(DEFAULT_THRESHOLD)) {
      return Optional.empty();
    }
    try {
      read(file, thresholdM);
      return Optional.empty();
    } catch (BadInputException e) {
      return Optional.of(e.getMessage());
    }
  }

  private GoalSequence load() {
    Mission loadedMission = read(getVariable(MISSION), getVariable(DEFAULT_THRESHOLD));
    log("mission " + loadedMission.origin() + " with goals " + names(loadedMission.goals()));
    loadedMission.warnings().forEach(warning -> log(LogLevelEnum.WARN, warning));
    GoalSequence loaded = new GoalSequence(loadedMission.goals(), getVariable(LOOP), options());
    home = loadedMission.home().map(place -> place.waypoint(HOME, getVariable(DEFAULT_THRESHOLD)));
    if (home.isPresent() && !loaded.knows(HOME)) {
      loaded.update(home.get());
    }
    return loaded;
  }

  private GoalSequence.Options options() {
    return GoalSequence.Options.valueOf(getVariable(OPTIONS));
  }

  @Override
  protected void configurationChanged(Set<String> variableNames) {
    if (variableNames.contains(MISSION.name())
        || variableNames.contains(DEFAULT_THRESHOLD.name())) {
      beginAnew();
    }
    if (FailsafeMissions.areConfiguredBy(variableNames)) {
      loadFailsafes();
    }
    if (variableNames.contains(LOOP.name()) || variableNames.contains(OPTIONS.name())) {
      (mission == null ? sequence : mission).rules(getVariable(LOOP), options());
      publishGoals();
    }
  }

  private void loadFailsafes() {
    try {
      failsafes.load();
    } catch (BadInputException e) {
      log(LogLevelEnum.ERROR, e.getMessage() + ": the failsafe missions stay as they were");
    }
  }

  private void beginAnew() {
    try {
      GoalSequence loaded = load();
      if (mission == null) {
        sequence = loaded;
      } else {
        mission = loaded; // begins when the failsafe is over
      }
    } catch (BadInputException e) {
      log(LogLevelEnum.ERROR, e.getMessage() + ": goes on with the mission before");
      return;
    }
    completed.clear();
    abandoned.clear();
    publishGoals();
  }

  @Override
  protected void begin() {
    publishGoals();
  }

  @Override
  public void callback(U2SAData data) {
    if (data instanceof FailsafeState failsafe) {
      react(failsafe.action());
    } else if (data instanceof GoalCommand command) {
      changeTo(command.uid());
    } else if (!(data instanceof GoalInformation goal)) {
      unexpected(data);
    } else if (goal.completed() || goal.abandoned()) {
      finish(goal);
    } else {
      update(goal);
    }
  }

  /** Turns to a failsafe's own mission, or back to where the mission was left. */
  private void react(FailsafeAction action) {
    if (action == pursuedFor) {
      return;
    }
    pursuedFor = action;
    Optional<GoalSequence> other = failsafes.sequence(action, home);
    if (other.isPresent()) {
      mission = mission == null ? sequence : mission;
      sequence = other.get();
      log(LogLevelEnum.WARN, "leaves the mission: " + action);
      publishGoals();
    } else if (mission != null && action == FailsafeAction.CONTINUE) {
      sequence = mission;
      mission = null;
      log("resumes the mission");
      publishGoals();
    }
  }

  private void finish(GoalInformation goal) {
    String uid = goal.uid();
    if (!sequence.finish(uid)) {
      String what = sequence.knows(uid) ? "is not current" : "is not known";
      log(LogLevelEnum.WARN, "report of goal \"" + uid + "\" left out: it " + what);
      return;
    }
    if (goal.completed()) {
      completed.add(uid);
      abandoned.remove(uid);
      log("goal \"" + uid + "\" completed");
    } else {
      abandoned.add(uid);
      log(LogLevelEnum.WARN, "goal \"" + uid + "\" given up by the planner");
    }
    publishGoals();
  }

  private void update(GoalInformation goal) {
    if (sequence.update(goal)) {
      log("goal \"" + goal.uid() + "\" updated");
    } else {
      log(
          LogLevelEnum.WARN,
          "goal \""
              + goal.uid()
              + "\" added; until another goal's next names it, or it is commanded, it is never pursued");
    }
    publishGoals();
  }

  private void changeTo(String uid) {
    if (!sequence.knows(uid)) {
      log(LogLevelEnum.WARN, "command to change to goal \"" + uid + "\" refused: it is not known");
      return;
    }
    sequence.changeTo(uid);
    log("changes to goal \"" + uid + "\" on command");
    publishGoals();
  }

  private void publishGoals() {
    List<GoalInformation> current = sequence.current();
    if (sequence.isOver()) {
      log("mission is over: completed " + completed + ", given up " + abandoned);
    } else {
      log("current goals " + names(current));
    }
    publish(Channels.GOALS, new GoalList().goals(current).upcoming(sequence.upcoming()));
  }

  private static List<String> names(List<GoalInformation> goals) {
    return goals.stream().map(GoalInformation::uid).collect(Collectors.toList());
  }
}
