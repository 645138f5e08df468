package org.u2sa.scenarios.report;

import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.u2sa.scenarios.report.Drawing.Pen;

/**
 * The track as a line on a panel, coloured by a quantity, with only as many points as the eye can
 * tell apart.
 */
final class TrackLine {

  private static final double POINT_SPACING = 1.0; // least distance of neighbouring points [px]

  private record Point(Point2D.Double place, double value) {}

  private final List<Point> points = new ArrayList<>();
  private final Quantity quantity;

  /**
   * @param quantity what colours it
   * @param position where on the panel a sample stands
   */
  TrackLine(
      List<TrackSample> track, Quantity quantity, Function<TrackSample, Point2D.Double> position) {
    this.quantity = quantity;
    for (int i = 0; i < track.size(); i++) {
      Point2D.Double pixel = position.apply(track.get(i));
      if (points.isEmpty()
          || i == track.size() - 1
          || points.get(points.size() - 1).place().distance(pixel) >= POINT_SPACING) {
        points.add(new Point(pixel, quantity.of().applyAsDouble(track.get(i))));
      }
    }
  }

  List<Point2D.Double> points() {
    return points.stream().map(Point::place).toList();
  }

  /** Draws the line; the quantity's range spans the colours. */
  void draw(Drawing drawing, double width) {
    List<Point2D.Double> run = new ArrayList<>();
    int step = -1;
    for (Point point : points) {
      int here = ColourScale.step(point.value(), quantity.low(), quantity.high());
      run.add(point.place());
      if (here != step) {
        flush(drawing, run, step, width);
        run = new ArrayList<>(List.of(point.place())); // the next colour starts where this one ends
        step = here;
      }
    }
    flush(drawing, run, step, width);
  }

  private static void flush(Drawing drawing, List<Point2D.Double> run, int step, double width) {
    if (step >= 0) {
      drawing.polyline(run, Pen.solid(ColourScale.colour(step), width));
    }
  }
}
