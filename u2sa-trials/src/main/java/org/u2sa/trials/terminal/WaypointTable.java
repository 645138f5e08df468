package org.u2sa.trials.terminal;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.u2sa.cli.terminal.Terminal;
import org.u2sa.report.score.FlightFigures;
import org.u2sa.report.score.ObstacleResult;
import org.u2sa.report.score.RunDetails;
import org.u2sa.report.score.RunOutcome;
import org.u2sa.report.score.RunScore;
import org.u2sa.report.score.WaypointResult;

/** Prints the results of a run: one line per waypoint, then the overall metrics. */
public final class WaypointTable {

  private static final int MIN_NAME = 8;
  private static final int NUMBERS_WIDTH = 51; // of all columns except the name
  private static final String ROW = "%3s  %s  %8s  ";
  private static final String ALTITUDE = "%10s  ";
  private static final String TIME = "%8s  ";

  private WaypointTable() {}

  /** Prints the result of a run. */
  public static void print(Terminal terminal, RunDetails facts, RunScore score) {
    List<WaypointResult> results = score.waypoints();
    Stream<String> names =
        Stream.concat(
            results.stream().map(each -> each.waypoint().name()),
            score.obstacles().stream().map(ObstacleResult::name));
    int longest = names.mapToInt(String::length).max().orElse(0);
    int width = Math.max(MIN_NAME, Math.min(longest, terminal.columns() - NUMBERS_WIDTH));
    boolean flight = score.flight().isPresent();
    String head =
        format(ROW, "", cell("waypoint", width), "miss [m]")
            + (flight ? format(ALTITUDE, "altitude") : "")
            + format(TIME, "time")
            + "captured";
    terminal.out().println(terminal.bold(terminal.fitted(head)));
    for (int i = 0; i < results.size(); i++) {
      row(terminal, i, results.get(i), width, flight);
    }
    obstacles(score, width).forEach(line -> terminal.out().println(terminal.fitted(line)));
    summary(score).forEach(line -> terminal.out().println(terminal.fitted(line)));
    String verdict = facts.verdict(score);
    terminal.out().println(score.success() ? terminal.good(verdict) : terminal.bad(verdict));
    if (score.outcome().crashed()) {
      terminal.out().println(terminal.bad("no success: " + contacts(score)));
    }
    if (score.outcome().stalled()) {
      terminal.out().println(terminal.bad("no success: the wing stalled in the air"));
    }
    score
        .outcome()
        .violations()
        .forEach(v -> terminal.out().println(terminal.bad(terminal.fitted("violation: " + v))));
  }

  private static String contacts(RunScore score) {
    return score.flight().isPresent()
        ? "the aircraft crashed"
        : format(
            score.outcome().contacts() == 1 ? "%d contact" : "%d contacts",
            score.outcome().contacts());
  }

  private static void row(
      Terminal terminal, int index, WaypointResult result, int width, boolean flight) {
    String numbers =
        format(
                ROW,
                index + 1,
                cell(result.waypoint().name(), width),
                number(flight ? "%.1f" : "%.2f", result.missM()))
            + (flight ? format(ALTITUDE, number("%+.1f m", result.altitudeErrorM())) : "")
            + format(TIME, result.timeS().isPresent() ? clock(result.timeS().getAsDouble()) : "-");
    String captured = result.captured() ? "yes" : "NO";
    String cut = terminal.fitted(numbers + captured);
    boolean whole = cut.length() == numbers.length() + captured.length();
    if (whole) {
      terminal
          .out()
          .println(
              numbers + (result.captured() ? terminal.good(captured) : terminal.bad(captured)));
    } else {
      terminal.out().println(cut);
    }
  }

  /** One line per surrounding object: distance and time of closest approach. */
  private static List<String> obstacles(RunScore score, int width) {
    List<String> lines = new ArrayList<>();
    String metres = score.flight().isPresent() ? "%.1f" : "%.2f";
    for (ObstacleResult result : score.obstacles()) {
      if (lines.isEmpty()) {
        lines.add("");
        lines.add(
            (format(ROW, "", cell("obstacle", width), "near [m]") + format(TIME, "time"))
                .stripTrailing());
      }
      String remark = result.touched() ? "TOUCHED" : result.moves() ? "moves" : "";
      lines.add(
          (format(ROW, "", cell(result.name(), width), format(metres, result.leastM()))
                  + format(TIME, clock(result.timeS()))
                  + remark)
              .stripTrailing());
    }
    return lines;
  }

  private static List<String> summary(RunScore score) {
    List<String> lines = new ArrayList<>();
    String metres = score.flight().isPresent() ? "%.1f m" : "%.2f m";
    lines.add("");
    lines.add(
        "cross-track RMS "
            + number(metres, score.crossTrackRmsM())
            + " (whole legs "
            + number(metres, score.crossTrackRmsWholeLegsM())
            + ")");
    if (score.flight().isPresent()) {
      lines.addAll(summary(score.flight().get(), score.outcome()));
    } else {
      lines.add("contacts " + score.outcome().contacts());
      score.outcome().figures().forEach((name, value) -> lines.add(format("%s %.3f", name, value)));
    }
    lines.add("simulated " + clock(score.simSeconds()));
    return lines;
  }

  private static List<String> summary(FlightFigures flight, RunOutcome outcome) {
    return List.of(
        "altitude on level legs: RMS "
            + number("%.1f m", flight.altitudeRmsM())
            + ", maximum "
            + number("%.1f m", flight.altitudeMaxErrorM()),
        "maximum bank "
            + number("%.1f deg", flight.maxBankDeg())
            + ", minimum airspeed "
            + number("%.1f m/s", flight.minAirspeedMps())
            + (flight.tookOff() ? "" : ", DID NOT TAKE OFF")
            + (outcome.crashed() ? ", CRASHED" : "")
            + (outcome.stalled() ? ", STALLED" : ""));
  }

  private static String cell(String text, int width) {
    String cut = text.length() <= width ? text : text.substring(0, width - 1) + "~";
    return cut + " ".repeat(width - cut.length());
  }

  private static String number(String pattern, OptionalDouble value) {
    return value.isPresent() ? format(pattern, value.getAsDouble()) : "-";
  }

  private static String clock(double seconds) {
    long whole = Math.round(seconds);
    return format("%d:%02d", whole / 60, whole % 60);
  }

  private static String format(String pattern, Object... values) {
    return String.format(Locale.ROOT, pattern, values);
  }
}
