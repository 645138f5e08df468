package org.u2sa.gcs.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import org.u2sa.gcs.draw.Box;
import org.u2sa.gcs.draw.Canvas;
import org.u2sa.gcs.draw.Canvas.Pixel;
import org.u2sa.gcs.draw.ColourScale;
import org.u2sa.gcs.draw.Stroke;
import org.u2sa.gcs.draw.TextStyle.Anchor;
import org.u2sa.gcs.draw.Ticks;

/**
 * Draws altitude against simulated time: planned and flown, with the moments at which waypoints
 * were met.
 */
final class ProfilePanel {

  private static final double HEADROOM = 0.08; // of the span, above and below
  private static final double[] TIME_STEPS_S = {
    5, 10, 30, 60, 120, 300, 600, 1200, 1800, 3600, 7200, 14_400, 36_000
  };
  private static final double NUMBER_SPACING = 22.0; // closer numbers take turns in two rows [px]
  private static final int MOST_TIMES = 14;

  private final Canvas canvas;
  private final Box frame;
  private final FlightPlan plan;
  private final List<FlightSample> track;
  private final List<WaypointResult> results;
  private final AltitudeRange altitudes;
  private final double bottomM;
  private final double topM;
  private final double startS;
  private final double endS;

  ProfilePanel(
      Canvas canvas,
      Box frame,
      FlightPlan plan,
      List<FlightSample> track,
      FlightScore score,
      AltitudeRange altitudes) {
    this.canvas = canvas;
    this.frame = frame;
    this.plan = plan;
    this.track = track;
    results = score.waypoints();
    this.altitudes = altitudes;
    double headroom = HEADROOM * (altitudes.highM() - altitudes.lowM());
    bottomM = altitudes.lowM() - headroom;
    topM = altitudes.highM() + headroom;
    startS = track.isEmpty() ? 0.0 : track.get(0).timeS();
    endS = Math.max(startS + 1.0, track.isEmpty() ? 0.0 : track.get(track.size() - 1).timeS());
  }

  void draw() {
    canvas.rectangle(frame, Ink.PANEL, null);
    grid();
    moments();
    canvas.clipped(frame, this::lines);
    canvas.rectangle(frame, null, Ink.FRAME);
    marks();
    key();
  }

  private void grid() {
    Ticks heights = Ticks.between(bottomM, topM, 7);
    for (double altitude : heights.values()) {
      canvas.line(frame.x(), y(altitude), frame.right(), y(altitude), Ink.GRID);
      canvas.text(
          frame.x() - 8.0,
          y(altitude) + 5.0,
          heights.label(altitude),
          Ink.TICK.anchored(Anchor.END));
    }
    for (double time : Ticks.every(timeStep(), startS, endS).values()) {
      canvas.line(x(time), frame.y(), x(time), frame.bottom(), Ink.GRID);
      canvas.text(x(time), frame.bottom() + 19.0, clock(time), Ink.TICK.anchored(Anchor.MIDDLE));
    }
    canvas.text(
        frame.right(),
        frame.bottom() + 40.0,
        "simulated time [min:s]",
        Ink.TICK.anchored(Anchor.END));
  }

  private double timeStep() {
    for (double step : TIME_STEPS_S) {
      if ((endS - startS) / step <= MOST_TIMES) {
        return step;
      }
    }
    return Ticks.stepFor((endS - startS) / MOST_TIMES);
  }

  /** A hairline where each waypoint was nearest, its number above the frame. */
  private void moments() {
    double lastX = Double.NEGATIVE_INFINITY;
    boolean raised = false;
    for (int i = 0; i < results.size(); i++) {
      OptionalDouble time = results.get(i).timeS();
      if (time.isEmpty()) {
        continue;
      }
      double x = x(time.getAsDouble());
      raised = x - lastX < NUMBER_SPACING && !raised;
      lastX = x;
      canvas.line(x, frame.y(), x, frame.bottom(), Stroke.dashed(Ink.PLANNED, 1.0, 3.0));
      canvas.text(
          x,
          frame.y() - (raised ? 23.0 : 7.0),
          String.valueOf(i + 1),
          Ink.LABEL.anchored(Anchor.MIDDLE));
    }
  }

  private void lines() {
    FlownLine flown = new FlownLine(track, s -> new Pixel(x(s.timeS()), y(s.altitudeM())));
    List<Pixel> area = new ArrayList<>(flown.pixels());
    if (!area.isEmpty()) {
      area.add(new Pixel(area.get(area.size() - 1).x(), frame.bottom()));
      area.add(new Pixel(area.get(0).x(), frame.bottom()));
    }
    canvas.polygon(area, Ink.FLOWN_AREA);
    planned().forEach(run -> canvas.polyline(run, Stroke.dashed(Ink.MUTED, 2.0, 7.0)));
    flown.draw(canvas, altitudes.lowM(), altitudes.highM(), 3.0);
  }

  /** The altitude of the target over time, in runs where there is one. */
  private List<List<Pixel>> planned() {
    List<List<Pixel>> runs = new ArrayList<>();
    List<Pixel> run = new ArrayList<>();
    int leg = -1;
    for (FlightSample sample : track) {
      if (sample.leg() != leg) {
        if (!run.isEmpty()) {
          run.add(new Pixel(x(sample.timeS()), run.get(run.size() - 1).y()));
        }
        leg = sample.leg();
        OptionalDouble altitude =
            leg >= 0 && leg < plan.waypoints().size()
                ? plan.waypoints().get(leg).altitudeM()
                : OptionalDouble.empty();
        if (altitude.isPresent()) {
          run.add(new Pixel(x(sample.timeS()), y(altitude.getAsDouble())));
        } else {
          runs.add(run);
          run = new ArrayList<>();
        }
      }
    }
    if (!run.isEmpty()) {
      run.add(new Pixel(x(endS), run.get(run.size() - 1).y()));
    }
    runs.add(run);
    return runs;
  }

  private void marks() {
    for (WaypointResult result : results) {
      if (result.timeS().isPresent() && result.waypoint().altitudeM().isPresent()) {
        Pixel at =
            new Pixel(
                x(result.timeS().getAsDouble()), y(result.waypoint().altitudeM().getAsDouble()));
        WaypointMark.draw(canvas, at, result.captured());
      }
    }
  }

  private void key() {
    double y = frame.bottom() + 40.0;
    double x = frame.x();
    canvas.text(x, y, "altitude above sea level [m]:", Ink.TICK);
    x += Ink.TICK.widthOf("altitude above sea level [m]:") + 24.0;
    canvas.line(x, y - 5.0, x + 34.0, y - 5.0, Stroke.dashed(Ink.MUTED, 2.0, 7.0));
    canvas.text(x + 42.0, y, "of the waypoint flown to", Ink.TICK);
    x += 42.0 + Ink.TICK.widthOf("of the waypoint flown to") + 32.0;
    canvas.line(
        x,
        y - 5.0,
        x + 34.0,
        y - 5.0,
        Stroke.solid(ColourScale.colour(ColourScale.STEPS / 2), 3.0));
    canvas.text(x + 42.0, y, "flown", Ink.TICK);
  }

  private double x(double timeS) {
    return frame.x() + frame.width() * (timeS - startS) / (endS - startS);
  }

  private double y(double altitudeM) {
    return frame.bottom() - frame.height() * (altitudeM - bottomM) / (topM - bottomM);
  }

  static String clock(double seconds) {
    long whole = Math.round(seconds);
    return String.format(Locale.ROOT, "%d:%02d", whole / 60, whole % 60);
  }
}
