package org.u2sa.cli.mission;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import org.u2sa.cli.terminal.Terminal;
import org.u2sa.cli.terminal.TextTable;
import org.u2sa.gcs.mission.MissionView;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.mission.MissionReport;

/** Formats a mission as a table, one goal per line. */
final class MissionTable {
  private static final double FAR_M = 1_000.0;

  private MissionTable() {}

  static List<String> lines(String systemId, MissionView mission, Terminal terminal) {
    MissionReport report = mission.report();
    List<String> lines = new ArrayList<>();
    lines.add(terminal.bold("System " + systemId + ", mission " + report.mission()));
    lines.add(summary(mission));
    report
        .failsafe()
        .ifPresent(
            action ->
                lines.add(terminal.bad("Failsafe " + action + " is active; the mission waits.")));
    if (report.paused()) {
      lines.add("The mission is paused; resume continues it.");
    }
    report.resumable().ifPresent(where -> lines.add("resume returns to " + where + "."));
    lines.add("");
    TextTable table =
        new TextTable(
            "",
            "GOAL",
            "CLASS",
            "STATE",
            "TIMES",
            "ARRIVED",
            "DISTANCE",
            "LIMIT",
            "NEXT",
            "REASON");
    for (int i = 0; i < report.goals().size(); i++) {
      GoalInformation goal = report.goals().get(i);
      long times = mission.timesFinished(i);
      table.add(
          report.current().contains(goal.uid()) ? ">" : "",
          goal.uid(),
          goal.typeChain().get(goal.typeChain().size() - 1),
          mission.status(goal),
          times > (goal.result().isPresent() ? 1 : 0) ? String.valueOf(times) : "",
          duration(mission.arrivedS(goal)),
          distance(mission.distanceM(goal)),
          duration(goal.timeLimit()),
          next(mission.next(goal)),
          goal.reason().orElse(""));
    }
    for (String line : table.lines()) {
      lines.add(line.startsWith(">") ? terminal.good(line) : line);
    }
    return lines;
  }

  private static String summary(MissionView mission) {
    MissionReport report = mission.report();
    long done = report.goals().stream().filter(GoalInformation::completed).count();
    String time =
        duration(OptionalDouble.of(report.elapsed()))
            + (report.timeLimit().isPresent() ? " of " + duration(report.timeLimit()) : "");
    String now =
        report.current().isEmpty() ? "over" : doing(report) + String.join(", ", report.current());
    return done + " of " + report.goals().size() + " goals done in " + time + ", " + now;
  }

  private static String doing(MissionReport report) {
    return report.paused() && report.failsafe().isEmpty() ? "paused at " : "pursuing ";
  }

  /** "gate, 2 times; dock; if failed: home". */
  static String next(Map<String, List<String>> next) {
    List<String> parts = new ArrayList<>();
    next.forEach(
        (when, names) -> {
          String all = names.isEmpty() ? "end" : String.join(", ", names);
          if (when.startsWith("if ")) {
            parts.add(when + ": " + all);
          } else {
            parts.add(when.isEmpty() ? all : all + " (" + when + ")");
          }
        });
    return String.join("; ", parts);
  }

  private static String duration(OptionalDouble seconds) {
    if (seconds.isEmpty()) {
      return "";
    }
    double value = seconds.getAsDouble();
    if (value < 60.0) {
      return String.format(Locale.ROOT, "%.1f s", value);
    }
    long whole = (long) value;
    return whole < 3600
        ? String.format(Locale.ROOT, "%d:%02d", whole / 60, whole % 60)
        : String.format(Locale.ROOT, "%d:%02d:%02d", whole / 3600, whole / 60 % 60, whole % 60);
  }

  private static String distance(OptionalDouble metres) {
    if (metres.isEmpty()) {
      return "";
    }
    double value = metres.getAsDouble();
    return value < FAR_M
        ? String.format(Locale.ROOT, "%.1f m", value)
        : String.format(Locale.ROOT, "%.2f km", value / FAR_M);
  }
}
