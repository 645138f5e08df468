package org.u2sa.scenarios.report;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.u2sa.gcs.draw.Canvas;
import org.u2sa.gcs.draw.Canvas.Pixel;
import org.u2sa.gcs.draw.ColourScale;
import org.u2sa.gcs.draw.Stroke;

/**
 * The track as a line on a panel, coloured by a quantity, with only as many points as the eye can
 * tell apart.
 */
final class TrackLine {

  private static final double POINT_SPACING = 1.0; // least distance of neighbouring points [px]

  private record Point(Pixel pixel, double value) {}

  private final List<Point> points = new ArrayList<>();
  private final Quantity quantity;

  /**
   * @param quantity what colours it
   * @param position where on the panel a sample stands
   */
  TrackLine(List<TrackSample> track, Quantity quantity, Function<TrackSample, Pixel> position) {
    this.quantity = quantity;
    for (int i = 0; i < track.size(); i++) {
      Pixel pixel = position.apply(track.get(i));
      if (points.isEmpty()
          || i == track.size() - 1
          || distance(points.get(points.size() - 1).pixel(), pixel) >= POINT_SPACING) {
        points.add(new Point(pixel, quantity.of().applyAsDouble(track.get(i))));
      }
    }
  }

  List<Pixel> pixels() {
    return points.stream().map(Point::pixel).toList();
  }

  /** Draws the line; the quantity's range spans the colours. */
  void draw(Canvas canvas, double width) {
    List<Pixel> run = new ArrayList<>();
    int step = -1;
    for (Point point : points) {
      int here = ColourScale.step(point.value(), quantity.low(), quantity.high());
      run.add(point.pixel());
      if (here != step) {
        flush(canvas, run, step, width);
        run = new ArrayList<>(List.of(point.pixel())); // the next colour starts where this one ends
        step = here;
      }
    }
    flush(canvas, run, step, width);
  }

  private static void flush(Canvas canvas, List<Pixel> run, int step, double width) {
    if (step >= 0) {
      canvas.polyline(run, Stroke.solid(ColourScale.colour(step), width));
    }
  }

  private static double distance(Pixel a, Pixel b) {
    return Math.hypot(a.x() - b.x(), a.y() - b.y());
  }
}
