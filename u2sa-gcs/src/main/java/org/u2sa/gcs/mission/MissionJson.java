package org.u2sa.gcs.mission;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.interfaces.JsonText;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.mission.MissionReport;

/** Formats a mission as JSON. Unknown values are omitted. */
public final class MissionJson {
  private MissionJson() {}

  public static String text(String systemId, MissionView mission) {
    MissionReport report = mission.report();
    List<JsonText> goals = new ArrayList<>();
    for (int i = 0; i < report.goals().size(); i++) {
      goals.add(goal(mission, report.goals().get(i), mission.timesFinished(i)));
    }
    return new JsonText()
        .put("system", systemId)
        .put("mission", report.mission())
        .put("over", report.current().isEmpty())
        .put("paused", report.paused())
        .put("elapsedS", report.elapsed())
        .put("timeLimitS", report.timeLimit())
        .put("current", report.current())
        .put("upcoming", report.upcoming())
        .put("failsafe", report.failsafe())
        .put("resumable", report.resumable())
        .put("goals", goals)
        .toString();
  }

  private static JsonText goal(MissionView mission, GoalInformation goal, long times) {
    List<JsonText> next = new ArrayList<>();
    mission
        .next(goal)
        .forEach(
            (when, names) ->
                next.add(
                    new JsonText()
                        .put("when", Optional.of(when).filter(text -> !text.isEmpty()))
                        .put("goals", names)));
    return new JsonText()
        .put("name", goal.uid())
        .put("class", goal.typeChain().get(goal.typeChain().size() - 1))
        .put("state", mission.status(goal))
        .put("result", goal.result().map(MissionView::words))
        .put("reason", goal.reason())
        .put("timesFinished", times)
        .put("arrivedS", mission.arrivedS(goal))
        .put("distanceM", mission.distanceM(goal))
        .put("timeLimitS", goal.timeLimit())
        .put("next", next);
  }
}
