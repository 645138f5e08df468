package org.u2sa.gcs.terminal;

import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import org.u2sa.gcs.report.FlightScore;
import org.u2sa.gcs.report.WaypointResult;

/** Prints how a flight went: a line a waypoint, then the figures of the whole. */
public final class WaypointTable {

  private static final int LEAST_NAME = 8;
  private static final int NUMBERS_WIDTH = 51; // of all columns but the name
  private static final String ROW = "%3s  %s  %8s  %10s  %8s  ";

  private WaypointTable() {}

  /** Prints {@code score}. */
  public static void print(Terminal terminal, FlightScore score) {
    List<WaypointResult> results = score.waypoints();
    int longest = results.stream().mapToInt(r -> r.waypoint().name().length()).max().orElse(0);
    int width = Math.max(LEAST_NAME, Math.min(longest, terminal.columns() - NUMBERS_WIDTH));
    String head =
        format(ROW, "", cell("waypoint", width), "miss [m]", "altitude", "time") + "captured";
    terminal.out().println(terminal.bold(terminal.fitted(head)));
    for (int i = 0; i < results.size(); i++) {
      row(terminal, i, results.get(i), width);
    }
    summary(score).forEach(line -> terminal.out().println(terminal.fitted(line)));
    String verdict = format("%d of %d waypoints captured", score.captured(), results.size());
    terminal.out().println(score.success() ? terminal.good(verdict) : terminal.bad(verdict));
    score
        .outcome()
        .violations()
        .forEach(v -> terminal.out().println(terminal.bad(terminal.fitted("violation: " + v))));
    terminal.out().flush();
  }

  private static void row(Terminal terminal, int index, WaypointResult result, int width) {
    String numbers =
        format(
            ROW,
            index + 1,
            cell(result.waypoint().name(), width),
            number("%.1f", result.missM()),
            number("%+.1f m", result.altitudeErrorM()),
            result.timeS().isPresent() ? clock(result.timeS().getAsDouble()) : "-");
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

  private static List<String> summary(FlightScore score) {
    return List.of(
        "",
        "cross-track RMS "
            + number("%.1f m", score.crossTrackRmsM())
            + " (whole legs "
            + number("%.1f m", score.crossTrackRmsWholeLegsM())
            + ")",
        "altitude on level legs: RMS "
            + number("%.1f m", score.altitudeRmsM())
            + ", at most "
            + number("%.1f m", score.altitudeMaxErrorM()),
        "bank at most "
            + number("%.1f deg", degrees(score.maxBankRad()))
            + ", airspeed at least "
            + number("%.1f m/s", score.minAirspeedMps())
            + (score.tookOff() ? "" : ", DID NOT TAKE OFF")
            + (score.outcome().crashed() ? ", CRASHED" : "")
            + (score.outcome().stalled() ? ", STALLED" : ""),
        "simulated " + clock(score.simSeconds()));
  }

  private static String cell(String text, int width) {
    String cut = text.length() <= width ? text : text.substring(0, width - 1) + "~";
    return cut + " ".repeat(width - cut.length());
  }

  private static OptionalDouble degrees(OptionalDouble radians) {
    return radians.isPresent() ? OptionalDouble.of(Math.toDegrees(radians.getAsDouble())) : radians;
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
