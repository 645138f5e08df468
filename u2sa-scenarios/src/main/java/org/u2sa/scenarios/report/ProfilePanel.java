package org.u2sa.scenarios.report;

import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import org.u2sa.scenarios.report.Drawing.Anchor;
import org.u2sa.scenarios.report.Drawing.Pen;

/**
 * Draws a quantity against simulated time: planned and true, with the moments at which waypoints
 * were met.
 */
final class ProfilePanel {

  private static final double HEADROOM = 0.08; // of the span, above and below
  private static final double[] TIME_STEPS_S = {
    5, 10, 30, 60, 120, 300, 600, 1200, 1800, 3600, 7200, 14_400, 36_000
  };
  private static final double NUMBER_SPACING = 22.0; // closer numbers take turns in two rows [px]
  private static final int MOST_TIMES = 14;

  private final Drawing drawing;
  private final Rectangle2D.Double frame;
  private final RunPlan plan;
  private final List<TrackSample> track;
  private final List<WaypointResult> results;
  private final Quantity quantity;
  private final Quantity colour;
  private final double bottom;
  private final double top;
  private final double startS;
  private final double endS;

  ProfilePanel(
      Drawing drawing,
      Rectangle2D.Double frame,
      RunPlan plan,
      List<TrackSample> track,
      RunScore score,
      Quantity quantity,
      Quantity colour) {
    this.drawing = drawing;
    this.frame = frame;
    this.plan = plan;
    this.track = track;
    results = score.waypoints();
    this.quantity = quantity;
    this.colour = colour;
    double headroom = HEADROOM * (quantity.high() - quantity.low());
    bottom = quantity.low() - headroom;
    top = quantity.high() + headroom;
    startS = track.isEmpty() ? 0.0 : track.get(0).timeS();
    endS = Math.max(startS + 1.0, track.isEmpty() ? 0.0 : track.get(track.size() - 1).timeS());
  }

  void draw() {
    drawing.draw(frame, Ink.PANEL, null);
    grid();
    moments();
    drawing.clipped(frame, this::lines);
    drawing.draw(frame, null, Ink.FRAME);
    marks();
    key();
  }

  private void grid() {
    Ticks heights = Ticks.between(bottom, top, 7);
    for (double value : heights.values()) {
      drawing.line(frame.x, y(value), frame.getMaxX(), y(value), Ink.GRID);
      drawing.text(frame.x - 8.0, y(value) + 5.0, heights.label(value), Ink.TICK, Anchor.END);
    }
    for (double time : Ticks.every(timeStep(), startS, endS).values()) {
      drawing.line(x(time), frame.y, x(time), frame.getMaxY(), Ink.GRID);
      drawing.text(x(time), frame.getMaxY() + 19.0, clock(time), Ink.TICK, Anchor.MIDDLE);
    }
    drawing.text(
        frame.getMaxX(), frame.getMaxY() + 40.0, "simulated time [min:s]", Ink.TICK, Anchor.END);
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
      drawing.line(x, frame.y, x, frame.getMaxY(), new Pen(Ink.PLANNED, 1.0, 3.0));
      drawing.text(
          x, frame.y - (raised ? 23.0 : 7.0), String.valueOf(i + 1), Ink.LABEL, Anchor.MIDDLE);
    }
  }

  private void lines() {
    TrackLine line =
        new TrackLine(
            track,
            colour,
            s -> new Point2D.Double(x(s.timeS()), y(quantity.of().applyAsDouble(s))));
    List<Point2D.Double> area = new ArrayList<>(line.points());
    if (!area.isEmpty()) {
      double base = quantity.base() < bottom ? frame.getMaxY() : y(quantity.base());
      area.add(new Point2D.Double(area.get(area.size() - 1).x, base));
      area.add(new Point2D.Double(area.get(0).x, base));
    }
    drawing.polygon(area, Ink.FLOWN_AREA);
    planned().forEach(run -> drawing.polyline(run, new Pen(Ink.MUTED, 2.0, 7.0)));
    line.draw(drawing, 3.0);
  }

  /** What is planned over time, in runs where there is one. */
  private List<List<Point2D.Double>> planned() {
    List<List<Point2D.Double>> runs = new ArrayList<>();
    List<Point2D.Double> run = new ArrayList<>();
    int leg = -1;
    for (TrackSample sample : track) {
      if (sample.leg() != leg) {
        if (!run.isEmpty()) {
          run.add(new Point2D.Double(x(sample.timeS()), run.get(run.size() - 1).y));
        }
        leg = sample.leg();
        OptionalDouble value =
            leg >= 0 && leg < plan.waypoints().size()
                ? quantity.planned().apply(plan.waypoints().get(leg))
                : OptionalDouble.empty();
        if (value.isPresent()) {
          run.add(new Point2D.Double(x(sample.timeS()), y(value.getAsDouble())));
        } else {
          runs.add(run);
          run = new ArrayList<>();
        }
      }
    }
    if (!run.isEmpty()) {
      run.add(new Point2D.Double(x(endS), run.get(run.size() - 1).y));
    }
    runs.add(run);
    return runs;
  }

  private void marks() {
    for (WaypointResult result : results) {
      OptionalDouble planned = quantity.planned().apply(result.waypoint());
      if (result.timeS().isPresent() && planned.isPresent()) {
        Point2D.Double at =
            new Point2D.Double(x(result.timeS().getAsDouble()), y(planned.getAsDouble()));
        WaypointSign.draw(drawing, at, result.captured());
      }
    }
  }

  private void key() {
    double y = frame.getMaxY() + 40.0;
    double x = frame.x;
    String name = quantity.name() + " [" + quantity.unit() + "]:";
    drawing.text(x, y, name, Ink.TICK);
    x += Ink.TICK.widthOf(name) + 24.0;
    drawing.line(x, y - 5.0, x + 34.0, y - 5.0, new Pen(Ink.MUTED, 2.0, 7.0));
    drawing.text(x + 42.0, y, quantity.plannedName(), Ink.TICK);
    x += 42.0 + Ink.TICK.widthOf(quantity.plannedName()) + 32.0;
    drawing.line(
        x, y - 5.0, x + 34.0, y - 5.0, Pen.solid(ColourScale.colour(ColourScale.STEPS / 2), 3.0));
    drawing.text(x + 42.0, y, plan.domain().moved(), Ink.TICK);
  }

  private double x(double timeS) {
    return frame.x + frame.width * (timeS - startS) / (endS - startS);
  }

  private double y(double value) {
    return frame.getMaxY() - frame.height * (value - bottom) / (top - bottom);
  }

  static String clock(double seconds) {
    long whole = Math.round(seconds);
    return String.format(Locale.ROOT, "%d:%02d", whole / 60, whole % 60);
  }
}
