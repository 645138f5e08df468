package org.u2sa.mission;

import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
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
  private final MissionRun run;
  private final Logger logger;
  private final MissionFiles files;
  private final Supplier<MissionSettings> settings;
  private final Map<FailsafeAction, List<GoalInformation>> goals =
      new EnumMap<>(FailsafeAction.class);
  private final Map<FailsafeAction, GoalInformation> homes = new EnumMap<>(FailsafeAction.class);

  /**
   * Reads the configured files.
   *
   * @throws org.u2sa.interfaces.BadInputException if one is wrong
   */
  FailsafeMissions(
      MissionRun run, MissionFiles files, Supplier<MissionSettings> settings, Logger logger) {
    this.run = run;
    this.logger = logger;
    this.files = files;
    this.settings = settings;
    load();
  }

  static boolean areConfiguredBy(Set<String> variables) {
    return variables.contains(MissionSettings.RETURN_MISSION)
        || variables.contains(MissionSettings.LAND_MISSION)
        || variables.contains(MissionSettings.DEFAULT_THRESHOLD);
  }

  /** Number of goals for LAND. */
  int landGoals() {
    return goals.get(FailsafeAction.LAND).size();
  }

  /**
   * Reloads the files.
   *
   * @throws org.u2sa.interfaces.BadInputException if one is wrong; then nothing has changed
   */
  void load() {
    MissionSettings now = settings.get();
    List<GoalInformation> returning =
        load(FailsafeAction.RETURN, MissionSettings.RETURN_MISSION, now.returnMission());
    List<GoalInformation> landing =
        load(FailsafeAction.LAND, MissionSettings.LAND_MISSION, now.landMission());
    goals.put(FailsafeAction.RETURN, returning);
    goals.put(FailsafeAction.LAND, landing);
  }

  private List<GoalInformation> load(FailsafeAction action, String variable, String path) {
    homes.remove(action);
    if (path.isEmpty()) {
      files.forget(variable);
      return Collections.emptyList();
    }
    Mission mission = files.load(variable, path, run.thresholdM());
    logger.log(LogLevelEnum.INFO, variable + " " + mission.origin() + " loaded");
    mission
        .home()
        .map(place -> place.waypoint(Home.NAME, run.thresholdM()))
        .ifPresent(home -> homes.put(action, renamed(home, action + " ")));
    return mission.goals().stream()
        .map(goal -> renamed(goal, action + " "))
        .collect(Collectors.toList());
  }

  /** Renames goals, because names equal to the mission's would hide the change from planners. */
  private static GoalInformation renamed(GoalInformation goal, String prefix) {
    GoalInformation copy = goal.copy();
    copy.uid(prefix + goal.uid());
    copy.next(renamed(goal.next(), prefix));
    for (GoalResult result : List.of(GoalResult.DONE, GoalResult.FAILED, GoalResult.TIMED_OUT)) {
      goal.nextIf(result).ifPresent(next -> copy.nextIf(result, renamed(next, prefix)));
    }
    goal.repeatFrom().ifPresent(from -> copy.repeatFrom(prefix + from));
    copy.freeze();
    return copy;
  }

  private static List<String> renamed(List<String> names, String prefix) {
    return names.stream().map(name -> prefix + name).collect(Collectors.toList());
  }

  /**
   * Goals for the action; empty if the mission continues or is merely held.
   *
   * @param home home of the mission
   */
  Optional<GoalSequence> sequence(FailsafeAction action, Optional<Waypoint> home) {
    if (action != FailsafeAction.RETURN && action != FailsafeAction.LAND) {
      return Optional.empty();
    }
    List<GoalInformation> own = goals.get(action);
    if (own.isEmpty() && action == FailsafeAction.LAND) {
      logger.log(LogLevelEnum.ERROR, "failsafe LAND without a LAND MISSION: returning");
      own = goals.get(FailsafeAction.RETURN);
    }
    if (own.isEmpty() && home.isPresent()) {
      own = Collections.singletonList(renamed(home.get(), FailsafeAction.RETURN + " "));
    }
    if (own.isEmpty()) {
      logger.log(
          LogLevelEnum.ERROR,
          "failsafe " + action + " without a RETURN MISSION or a home: holding");
      return Optional.of(ended());
    }
    GoalSequence sequence = new GoalSequence(own, false, GoalSequence.Options.ALL);
    homes.values().stream().filter(each -> !sequence.knows(each.uid())).forEach(sequence::update);
    return Optional.of(sequence);
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
