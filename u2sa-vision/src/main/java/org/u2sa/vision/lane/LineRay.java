package org.u2sa.vision.lane;

import java.util.List;
import org.u2sa.messages.frame.Point;

/** A ray cast from a point to find lines. Coordinates in metres from the map's anchor. */
final class LineRay {
  private final Point from;
  private final double dx;
  private final double dy;
  private final double reachM;
  private double metres = Double.NaN;

  /**
   * @param dx direction, as a unit vector
   * @param dy see dx
   */
  LineRay(Point from, double dx, double dy, double reachM) {
    this.from = from;
    this.dx = dx;
    this.dy = dy;
    this.reachM = reachM;
  }

  /** Line that the ray hits closest to an expected distance; null if none. */
  DrivenLane.Known nearest(List<DrivenLane.Known> lines, double expectedM) {
    DrivenLane.Known found = null;
    metres = Double.NaN;
    for (DrivenLane.Known known : lines) {
      for (int i = 1; i < known.line().size(); i++) {
        Point end = known.line().get(i);
        if (Math.abs(end.x() - from.x()) > reachM || Math.abs(end.y() - from.y()) > reachM) {
          continue; // pieces are short
        }
        double at = met(known.line().get(i - 1), end);
        if (at <= reachM && !(Math.abs(at - expectedM) >= Math.abs(metres - expectedM))) {
          metres = at;
          found = known;
        }
      }
    }
    return found;
  }

  /** Distance of the line found [m]; NaN if none. */
  double metres() {
    return metres;
  }

  /** Distance along the ray at which it hits a line segment; infinite if it does not. */
  private double met(Point a, Point b) {
    double sideA = dx * (a.y() - from.y()) - dy * (a.x() - from.x());
    double sideB = dx * (b.y() - from.y()) - dy * (b.x() - from.x());
    if (sideA * sideB > 0.0 || sideA == sideB) {
      return Double.POSITIVE_INFINITY;
    }
    double share = sideA / (sideA - sideB);
    double x = a.x() + share * (b.x() - a.x()) - from.x();
    double y = a.y() + share * (b.y() - a.y()) - from.y();
    double along = x * dx + y * dy;
    return along > 0.0 ? along : Double.POSITIVE_INFINITY;
  }
}
