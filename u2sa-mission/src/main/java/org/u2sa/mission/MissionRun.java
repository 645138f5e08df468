package org.u2sa.mission;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleSupplier;
import java.util.stream.Collectors;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.mission.MissionReport;

/** The current mission and its progress. Confined to the manager's thread. */
final class MissionRun {
  private final Clock clock;
  private final DoubleSupplier thresholdM;
  private Mission mission; // as in its file
  private MissionProgress progress;
  private String driver = ""; // who drives the vehicle by hand; empty: nobody

  /**
   * @param thresholdM default horizontal threshold of waypoints [m]
   */
  MissionRun(Clock clock, DoubleSupplier thresholdM) {
    this.clock = clock;
    this.thresholdM = thresholdM;
  }

  /** The mission as in its file. */
  Mission mission() {
    return mission;
  }

  void mission(Mission loaded) {
    mission = loaded;
  }

  MissionProgress progress() {
    return progress;
  }

  void progress(MissionProgress reached) {
    progress = reached;
  }

  void drivenBy(String operator) {
    driver = operator;
  }

  /** Reason not to lead the vehicle to a goal; empty if there is none. */
  Optional<String> objection() {
    return driver.isEmpty()
        ? Optional.empty()
        : Optional.of(
            "the vehicle is driven by hand by \"" + driver + "\"; expected the order afterwards");
  }

  /** Default horizontal threshold of waypoints [m]. */
  double thresholdM() {
    return thresholdM.getAsDouble();
  }

  long micros() {
    return clock.micros();
  }

  /**
   * Creates the answer to a request for the mission's progress.
   *
   * @param manager the Mission Manager's name
   * @param resumable position to which RESUME would return; empty if none
   */
  MissionReport report(String requestId, String manager, Optional<String> resumable) {
    GoalSequence pursued = progress.pursued();
    List<GoalInformation> goals = new ArrayList<>();
    List<Double> finished = new ArrayList<>();
    add(progress.mission().book, goals, finished);
    if (progress.isLeft()) {
      add(pursued.book, goals, finished);
    }
    MissionReport report =
        new MissionReport()
            .requestId(requestId)
            .serviceName(manager)
            .mission(mission.origin())
            .goals(goals)
            .finished(finished)
            .current(names(pursued.current()))
            .upcoming(names(pursued.upcoming()))
            .sequence(progress.mission().followers.order())
            .elapsed(progress.elapsedS());
    if (progress.isLeft()) {
      report.failsafe(progress.pursuedFor().name());
    }
    mission.timeLimit().ifPresent(report::timeLimit);
    mission.home().ifPresent(home -> home.z().ifPresent(report::homeAltitude));
    progress.beganMicros().ifPresent(report::began);
    resumable.ifPresent(report::resumable);
    if (progress.isPaused()) {
      report.paused(true);
    }
    return report;
  }

  private static void add(GoalBook book, List<GoalInformation> goals, List<Double> finished) {
    for (String uid : book.names()) {
      goals.add(book.goal(uid));
      finished.add((double) book.timesFinished(uid));
    }
  }

  static List<String> names(List<GoalInformation> goals) {
    return goals.stream().map(GoalInformation::uid).collect(Collectors.toList());
  }
}
