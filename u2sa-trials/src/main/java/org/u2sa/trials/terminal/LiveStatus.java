package org.u2sa.trials.terminal;

import java.util.List;
import java.util.Locale;
import java.util.function.DoubleSupplier;
import org.u2sa.cli.terminal.Terminal;
import org.u2sa.report.score.TrackSample;

/**
 * Shows the progress of a run. On a terminal, redraws a panel in place at most ten times a second
 * of {@link Moment#elapsedS()}; to a pipe or file, prints a line at each change of phase or
 * waypoint and every ten simulated seconds. Thread-safe.
 */
public final class LiveStatus implements AutoCloseable {

  private static final double REDRAW_S = 0.1;
  private static final double LINE_S = 10.0;
  private static final int BAR_WIDTH = 20;
  private static final String CLEAR_TO_END_OF_LINE = "\u001b[K";
  private static final String CLEAR_TO_END_OF_SCREEN = "\u001b[J";

  private final Terminal terminal;
  private Moment shown; // last one printed
  private Moment newest;
  private int panelLines; // lines to move up for the next redraw
  private boolean closed;

  public LiveStatus(Terminal terminal) {
    this.terminal = terminal;
  }

  /** Updates the status; cheap if not due for display. */
  public synchronized void update(Moment status) {
    newest = status;
    if (isDue(status)) {
      show(status);
    }
  }

  /** Prints a line about an event, above the panel on a terminal. */
  public synchronized void print(String line) {
    if (panelLines > 0) {
      terminal.out().print(up() + '\r' + CLEAR_TO_END_OF_SCREEN);
      panelLines = 0;
    }
    terminal.out().println(line);
    if (terminal.redraws() && newest != null && !closed) {
      show(newest);
    }
  }

  private String up() {
    return "\u001b[" + panelLines + 'A';
  }

  /** Shows the last moment unconditionally, and leaves the cursor below it. */
  @Override
  public synchronized void close() {
    closed = true;
    if (newest != null && newest != shown) {
      show(newest);
    }
    panelLines = 0;
  }

  private boolean isDue(Moment status) {
    if (shown == null) {
      return true;
    }
    if (terminal.redraws()) {
      return status.elapsedS() - shown.elapsedS() >= REDRAW_S;
    }
    return status.waypoint() != shown.waypoint()
        || !status.phase().equals(shown.phase())
        || status.simulatedS() - shown.simulatedS() >= LINE_S;
  }

  private void show(Moment status) {
    shown = status;
    if (terminal.redraws()) {
      redraw(panel(status));
    } else {
      terminal.out().println(line(status));
    }
    terminal.out().flush();
  }

  private void redraw(List<String> lines) {
    StringBuilder text = new StringBuilder();
    if (panelLines > 0) {
      text.append(up());
    }
    for (int i = 0; i < lines.size(); i++) {
      String fitted = terminal.fitted(lines.get(i));
      text.append('\r')
          .append(i == 0 ? terminal.bold(fitted) : fitted)
          .append(CLEAR_TO_END_OF_LINE)
          .append('\n');
    }
    terminal.out().print(text);
    panelLines = lines.size();
  }

  private static List<String> panel(Moment s) {
    return List.of(
        format("%-10s %s %s", s.phase(), bar(s), target(s)),
        figures(
            s.sample(),
            "   ",
            "altitude %6.0f m   speed %5.1f m/s   bank %+4.0f deg",
            "speed %5.2f m/s   heading %3d deg"),
        format("simulated %s   elapsed %s%s", clock(s.simulatedS()), clock(s.elapsedS()), rate(s)));
  }

  private static String line(Moment s) {
    return format(
        "%s  %-10s %s  %s  elapsed %s",
        clock(s.simulatedS()),
        s.phase(),
        target(s),
        figures(
            s.sample(),
            "  ",
            "altitude %.0f m  speed %.1f m/s  bank %+.0f deg",
            "speed %.2f m/s  heading %d deg"),
        clock(s.elapsedS()));
  }

  private static String figures(TrackSample sample, String gap, String inFlight, String onGround) {
    String metres = "%+.2f m";
    String figures;
    if (sample.flight().isPresent()) {
      TrackSample.Flight flight = sample.flight().get();
      metres = "%+.0f m";
      figures =
          format(
              inFlight,
              sample.altitudeM(),
              flight.calibratedAirspeedMps(),
              Math.toDegrees(flight.rollRad()));
    } else {
      long heading = Math.round(Math.toDegrees(sample.headingRad()));
      figures = format(onGround, sample.groundSpeedMps(), Math.floorMod(heading, 360L));
    }
    return sample.crossTrackM().isPresent()
        ? figures + gap + "off track " + format(metres, sample.crossTrackM().getAsDouble())
        : figures;
  }

  private static String target(Moment s) {
    if (s.waypoint() == 0) {
      return "no waypoint";
    }
    if (s.waypoint() > s.waypoints()) {
      return "no waypoint left";
    }
    String name = s.waypointName().isEmpty() ? "" : " (" + s.waypointName() + ")";
    String distance =
        s.sample().flight().isPresent()
            ? format("%.2f km", s.distanceM().getAsDouble() / 1000.0)
            : format("%.1f m", s.distanceM().getAsDouble());
    return format("waypoint %d of %d%s, %s to go", s.waypoint(), s.waypoints(), name, distance);
  }

  private static String bar(Moment s) {
    int done =
        s.waypoints() == 0
            ? 0
            : BAR_WIDTH * Math.max(0, Math.min(s.waypoints(), s.waypoint() - 1)) / s.waypoints();
    return "[" + "#".repeat(done) + ".".repeat(BAR_WIDTH - done) + "]";
  }

  private static String rate(Moment s) {
    return s.elapsedS() < 1.0
        ? ""
        : format("   (%.0f times real time)", s.simulatedS() / s.elapsedS());
  }

  private static String clock(double seconds) {
    long whole = (long) Math.floor(seconds);
    return format("%02d:%02d", whole / 60, whole % 60);
  }

  private static String format(String pattern, Object... values) {
    return String.format(Locale.ROOT, pattern, values);
  }

  /**
   * A moment of a run, for display.
   *
   * @param sample ground truth and activity of the vehicle
   * @param waypoint number of the target waypoint, from 1; 0 if none; more than {@code waypoints}
   *     if none is left
   * @param waypoints number of waypoints of the mission
   * @param waypointName name of the target waypoint; may be empty
   * @param distanceM horizontal distance to it [m]; evaluated only if shown
   * @param elapsedS wall-clock time since the start [s]
   */
  public record Moment(
      TrackSample sample,
      int waypoint,
      int waypoints,
      String waypointName,
      DoubleSupplier distanceM,
      double elapsedS) {

    /** Activity of the vehicle, e.g. {@code CLIMB}. */
    String phase() {
      return sample.phase();
    }

    /** Simulated time since the start [s]. */
    double simulatedS() {
      return sample.timeS();
    }
  }
}
