package org.u2sa.trials.run;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalResult;
import org.u2sa.mission.Mission;
import org.u2sa.report.EscapedXml;

/** Writes the order and time limits of a mission's goals as XML. */
final class GoalLinksXml {
  private static final Map<GoalResult, String> RESULTS = new LinkedHashMap<>();

  static {
    RESULTS.put(GoalResult.DONE, "done");
    RESULTS.put(GoalResult.FAILED, "failed");
    RESULTS.put(GoalResult.TIMED_OUT, "timed out");
  }

  private GoalLinksXml() {}

  /** Whether the goal names its successor explicitly. */
  static boolean hasLinks(GoalInformation goal) {
    return !goal.next().isEmpty()
        || goal.repeatFrom().isPresent()
        || RESULTS.keySet().stream().anyMatch(result -> goal.nextIf(result).isPresent());
  }

  /** Appends the time limit of a mission. */
  static void limit(StringBuilder text, Mission mission) {
    if (mission.timeLimit().isPresent()) {
      text.append("  <timeLimit unit=\"s\" next=\"")
          .append(EscapedXml.of(String.join(", ", mission.afterTimeLimit())))
          .append("\">")
          .append(mission.timeLimit().getAsDouble())
          .append("</timeLimit>\n");
    }
  }

  /** Appends the successors of a goal and its time limit. */
  static void links(StringBuilder text, GoalInformation goal) {
    if (!goal.next().isEmpty()) {
      element(text, "next", goal.next());
    }
    RESULTS.forEach(
        (result, words) ->
            goal.nextIf(result)
                .ifPresent(
                    next ->
                        element(
                            text,
                            (next.isEmpty() ? "end" : "next") + " if=\"" + words + "\"",
                            next)));
    goal.repeatFrom()
        .ifPresent(
            from ->
                element(
                    text,
                    "repeat from=\""
                        + EscapedXml.of(from)
                        + "\" times=\""
                        + goal.repeatTimes().orElse(1)
                        + "\"",
                    List.of()));
    goal.choose().ifPresent(count -> element(text, "choose", List.of(String.valueOf(count))));
    goal.timeLimit()
        .ifPresent(seconds -> element(text, "timeLimit", List.of(String.valueOf(seconds))));
  }

  private static void element(StringBuilder text, String tag, List<String> values) {
    text.append("    <").append(tag);
    if (values.isEmpty()) {
      text.append("/>\n");
      return;
    }
    text.append('>')
        .append(EscapedXml.of(String.join(", ", values)))
        .append("</")
        .append(tag.split(" ")[0])
        .append(">\n");
  }
}
