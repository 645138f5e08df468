package org.u2sa.vision.line;

import java.util.List;
import org.u2sa.messages.frame.Point;

/**
 * A painted line, as far as it is seen in one piece.
 *
 * @param points along its middle, LEVEL, in order; two at least
 * @param support share of its length on which paint is seen, 0…1
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
