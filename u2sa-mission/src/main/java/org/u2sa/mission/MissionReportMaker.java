package org.u2sa.mission;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.mission.MissionReport;

/** Creates mission reports. */
final class MissionReportMaker {
  private MissionReportMaker() {}

  /**
   * Creates the answer to a request.
   *
   * @param manager the Mission Manager's name
   * @param resumable where RESUME would return to; empty: nowhere
   */
  static MissionReport report(
      MissionRun run, String requestId, String manager, Optional<String> resumable) {
    MissionProgress progress = run.progress();
    GoalSequence pursued = progress.pursued();
    List<GoalInformation> goals = new ArrayList<>();
    List<Double> finished = new ArrayList<>();
    add(progress.mission().book(), goals, finished);
    if (progress.isLeft()) {
      add(pursued.book(), goals, finished);
    }
    MissionReport report =
        new MissionReport()
            .requestId(requestId)
            .serviceName(manager)
            .mission(run.mission().origin())
            .goals(goals)
            .finished(finished)
            .current(names(pursued.current()))
            .upcoming(names(pursued.upcoming()))
            .sequence(progress.mission().followers().order())
            .elapsed(progress.elapsedS());
    if (progress.isLeft()) {
      report.failsafe(progress.pursuedFor().name());
    }
    run.mission().timeLimit().ifPresent(report::timeLimit);
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

  private static List<String> names(List<GoalInformation> goals) {
    return goals.stream().map(GoalInformation::uid).collect(Collectors.toList());
  }
}
