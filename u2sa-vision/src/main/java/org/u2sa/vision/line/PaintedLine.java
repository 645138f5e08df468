package org.u2sa.vision.line;

import java.util.List;
import org.u2sa.messages.frame.Point;

/**
 * A visible piece of a painted line.
 *
 * @param points centre line, LEVEL, in order; at least two
 * @param support share of its length with visible paint, 0…1
 */
public record PaintedLine(List<Point> points, double support) {
  /** Length along the points [m]. */
  public double lengthM() {
    double length = 0.0;
    for (int i = 1; i < points.size(); i++) {
      length += points.get(i).distanceTo(points.get(i - 1));
    }
    return length;
  }
}
