package org.u2sa.scenarios.report;

import java.util.List;
import org.u2sa.gcs.draw.Canvas;
import org.u2sa.gcs.draw.Stroke;

/**
 * The sign of a waypoint: a dot if captured, a cross if not, so that form tells what colour tells.
 */
final class WaypointMark {

  /** Half the size of the sign [px]. */
  static final double RADIUS = 5.0;

  private WaypointMark() {}

  static void draw(Canvas canvas, Canvas.Pixel at, boolean captured) {
    if (captured) {
      canvas.circle(at.x(), at.y(), RADIUS, Ink.CAPTURED, Stroke.solid(Ink.PAPER, 1.5));
      return;
    }
    for (Stroke stroke : List.of(Stroke.solid(Ink.PAPER, 6.0), Stroke.solid(Ink.MISSED, 3.0))) {
      canvas.line(at.x() - RADIUS, at.y() - RADIUS, at.x() + RADIUS, at.y() + RADIUS, stroke);
      canvas.line(at.x() - RADIUS, at.y() + RADIUS, at.x() + RADIUS, at.y() - RADIUS, stroke);
    }
  }
}
