package org.u2sa.mission;

import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.log.Logger;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalResult;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.safety.FailsafeAction;

/** The goals for the failsafes RETURN and LAND. */
final class FailsafeMissions {
  private static final int MAX_CHARS = 1_000; // maximum length of a UID

  private final MissionRun run;
  private final Logger logger;
  private final MissionFiles files;
  private final Supplier<MissionVariables> settings;
  private final Map<FailsafeAction, Goals> loaded = new EnumMap<>(FailsafeAction.class);

  /**
   * Content of a file.
   *
   * @param home home position in the file, or empty
   */
  private record Goals(List<GoalInformation> goals, Optional<GoalInformation> home) {}

  /** Reads the configured files; throws if one is invalid. */
  FailsafeMissions(
      MissionRun run, MissionFiles files, Supplier<MissionVariables> settings, Logger logger) {
    this.run = run;
    this.logger = logger;
    this.files = files;
    this.settings = settings;
    load();
  }

  static boolean areConfiguredBy(Set<String> variables) {
    return variables.contains(MissionVariables.RETURN_MISSION)
        || variables.contains(MissionVariables.LAND_MISSION)
        || variables.contains(MissionVariables.DEFAULT_THRESHOLD);
  }

  /** Goals of the LAND MISSION, or else of the mission's landing; empty without either. */
  List<GoalInformation> landGoals() {
    return goals(FailsafeAction.LAND);
  }

  private List<GoalInformation> goals(FailsafeAction action) {
    List<GoalInformation> own = loaded.get(action).goals();
    return own.isEmpty()
        ? run.progress().mission().landing().stream()
            .map(goal -> renamed(goal, action + " "))
            .collect(Collectors.toList())
        : own;
  }

  /** Reloads the files; if one is invalid, throws and keeps the previous ones. */
  void load() {
    MissionVariables now = settings.get();
    Goals returning =
        load(FailsafeAction.RETURN, MissionVariables.RETURN_MISSION, now.returnMission());
    Goals landing = load(FailsafeAction.LAND, MissionVariables.LAND_MISSION, now.landMission());
    loaded.put(FailsafeAction.RETURN, returning);
    loaded.put(FailsafeAction.LAND, landing);
  }

  private Goals load(FailsafeAction action, String variable, String path) {
    if (path.isEmpty()) {
      files.forget(variable);
      return new Goals(Collections.emptyList(), Optional.empty());
    }
    Mission mission = files.load(variable, run.thresholdM());
    logger.log(LogLevelEnum.INFO, variable + " " + mission.origin() + " loaded");
    return new Goals(
        mission.goals().stream()
            .map(goal -> renamed(goal, action + " "))
            .collect(Collectors.toList()),
        mission
            .home()
            .map(place -> place.waypoint(Home.NAME, run.thresholdM()))
            .map(home -> renamed(home, action + " ")));
  }

  /** Renames goals, because names equal to the mission's would hide the change from planners. */
  private static GoalInformation renamed(GoalInformation goal, String prefix) {
    GoalInformation copy = goal.copy();
    copy.uid(name(prefix, goal.uid()));
    copy.next(renamed(goal.next(), prefix));
    for (GoalResult result : List.of(GoalResult.DONE, GoalResult.FAILED, GoalResult.TIMED_OUT)) {
      goal.nextIf(result).ifPresent(next -> copy.nextIf(result, renamed(next, prefix)));
    }
    goal.repeatFrom().ifPresent(from -> copy.repeatFrom(name(prefix, from)));
    copy.freeze();
    return copy;
  }

  /** Whether current goals lead home or to a landing, rather than along the mission. */
  boolean leadBack(Set<String> current) {
    List<String> own = MissionRun.names(run.mission().goals());
    return !current.isEmpty()
        && current.stream().allMatch(uid -> !own.contains(uid) && leadsBack(uid));
  }

  private static boolean leadsBack(String uid) {
    return uid.equals(Home.NAME)
        || uid.startsWith(FailsafeAction.RETURN + " ")
        || uid.startsWith(FailsafeAction.LAND + " ");
  }

  /** Goal that leads to a return place. */
  static GoalInformation returning(Waypoint place) {
    return renamed(place, FailsafeAction.RETURN + " ");
  }

  /** New name of a goal; a hash if it would be too long. */
  private static String name(String prefix, String uid) {
    boolean isShort = prefix.length() + uid.length() <= MAX_CHARS;
    return prefix + (isShort ? uid : Integer.toHexString(uid.hashCode()));
  }

  private static List<String> renamed(List<String> names, String prefix) {
    return names.stream().map(each -> name(prefix, each)).collect(Collectors.toList());
  }

  /**
   * Goals for the action; empty if the mission continues or is merely held.
   *
   * @param place nearest return place
   * @param way waypoints that lead to a given one within the fence
   */
  Optional<GoalSequence> sequence(
      FailsafeAction action,
      Optional<Waypoint> place,
      Function<Waypoint, Optional<List<Waypoint>>> way) {
    if (action != FailsafeAction.RETURN && action != FailsafeAction.LAND) {
      return Optional.empty();
    }
    List<GoalInformation> own = own(action, place);
    if (own.isEmpty()) {
      String problem = "failsafe " + action + " without a RETURN MISSION or a home: holding";
      logger.log(LogLevelEnum.ERROR, problem);
      return Optional.of(ended());
    }
    List<GoalInformation> goals = new ArrayList<>(own);
    if (own.get(0) instanceof Waypoint first) {
      Optional<List<Waypoint>> before = way.apply(first);
      if (before.isEmpty()) {
        String problem = "failsafe " + action + ": the fence leaves no way to its goal: holding";
        logger.log(LogLevelEnum.ERROR, problem);
        return Optional.of(ended());
      }
      before
          .get()
          .forEach(each -> goals.add(goals.size() - own.size(), renamed(each, action + " ")));
    }
    GoalSequence sequence = new GoalSequence(goals, false, GoalSequence.Options.ALL);
    loaded.values().stream()
        .flatMap(each -> each.home().stream())
        .filter(each -> !sequence.knows(each.uid()))
        .forEach(sequence::update);
    return Optional.of(sequence);
  }

  private List<GoalInformation> own(FailsafeAction action, Optional<Waypoint> place) {
    List<GoalInformation> own = goals(action);
    if (own.isEmpty() && action == FailsafeAction.LAND) {
      logger.log(LogLevelEnum.ERROR, "failsafe LAND without a LAND MISSION: returning");
      own = loaded.get(FailsafeAction.RETURN).goals();
    }
    return own.isEmpty() && place.isPresent()
        ? Collections.singletonList(returning(place.get()))
        : own;
  }

  /** An empty set of goals: the planner holds as at the end of a mission. */
  private static GoalSequence ended() {
    GoalInformation none = new Waypoint().uid("none").horizontalThreshold(1.0);
    GoalSequence sequence =
        new GoalSequence(Collections.singletonList(none), false, GoalSequence.Options.ALL);
    sequence.finish(none.uid());
    return sequence;
  }
}
