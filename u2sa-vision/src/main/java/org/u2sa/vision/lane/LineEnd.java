package org.u2sa.vision.lane;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.messages.frame.Point;

/**
 * One end of a line.
 *
 * @param at the outermost point
 * @param dx direction outward, as a unit vector
 * @param dy see dx
 */
record LineEnd(List<Point> line, Point at, double dx, double dy) {
  private static final double TANGENT_M = 0.8; // length over which the direction is measured
  private static final double MAX_BEND = 0.5; // [1/m]
  private static final double CURVE_STEP_M = 0.3;

  static LineEnd first(List<Point> line) {
    return of(line, 0, 1);
  }

  static LineEnd last(List<Point> line) {
    return of(line, line.size() - 1, -1);
  }

  private static LineEnd of(List<Point> line, int at, int step) {
    int inner = at;
    double gone = 0.0;
    while (gone < TANGENT_M && inner + step >= 0 && inner + step < line.size()) {
      gone += LineGeometry.metres(line.get(inner), line.get(inner + step));
      inner += step;
    }
    Point end = line.get(at);
    Point before = line.get(inner);
    double length = Math.max(1.0e-9, LineGeometry.metres(end, before));
    return new LineEnd(line, end, (end.x() - before.x()) / length, (end.y() - before.y()) / length);
  }

  /** The same end of a longer line. */
  LineEnd of(List<Point> longer) {
    return new LineEnd(longer, at, dx, dy);
  }

  /** Point this many steps before the end. */
  Point before(int steps) {
    return line.get(isLast() ? line.size() - 1 - steps : steps);
  }

  /** Index of the point this many steps before the end. */
  int index(int steps) {
    return isLast() ? line.size() - 1 - steps : steps;
  }

  private boolean isLast() {
    return at == line.get(line.size() - 1);
  }

  /** Curvature in outward direction [1/m], positive anticlockwise; clamped. */
  private double bend() {
    int far = Math.min(line.size() - 1, (int) Math.round(2.0 * TANGENT_M / LineSamples.STEP_M));
    int middle = far / 2;
    if (middle < 2) {
      return 0.0;
    }
    Point a = before(far);
    Point b = before(middle);
    double first = Math.atan2(b.y() - a.y(), b.x() - a.x());
    double second = Math.atan2(at.y() - b.y(), at.x() - b.x());
    double turned = Math.IEEEremainder(second - first, 2.0 * Math.PI);
    double way = 0.5 * (LineGeometry.metres(a, b) + LineGeometry.metres(b, at));
    return Math.max(-MAX_BEND, Math.min(MAX_BEND, turned / Math.max(0.1, way)));
  }

  interface Stop {
    boolean isBetween(Point from, Point to);
  }

  /** Extends the line with the curvature of its end. */
  List<Point> extension(double lengthM, Stop stop) {
    List<Point> points = new ArrayList<>(List.of(at));
    double bend = bend();
    double heading = Math.atan2(dy, dx) + 0.5 * bend * TANGENT_M;
    Point to = at;
    for (double gone = 0.0; gone < lengthM - 1.0e-9; gone += CURVE_STEP_M) {
      double step = Math.min(CURVE_STEP_M, lengthM - gone);
      heading += bend * step;
      Point from = to;
      to = Point.of(to.x() + step * Math.cos(heading), to.y() + step * Math.sin(heading), 0.0);
      if (stop.isBetween(from, to)) {
        break;
      }
      points.add(to);
    }
    return points;
  }

  /** Cubic Hermite curve from this end to another, tangent to both. */
  List<Point> curveTo(LineEnd other) {
    double gap = LineGeometry.metres(at, other.at);
    int steps = Math.max(1, (int) Math.ceil(gap / CURVE_STEP_M));
    List<Point> points = new ArrayList<>();
    for (int i = 0; i <= steps; i++) {
      double t = (double) i / steps;
      double h10 = t * (1.0 - t) * (1.0 - t) * gap;
      double h11 = t * t * (t - 1.0) * gap;
      double h01 = t * t * (3.0 - 2.0 * t);
      points.add(
          Point.of(
              at.x() + h01 * (other.at.x() - at.x()) + h10 * dx - h11 * other.dx,
              at.y() + h01 * (other.at.y() - at.y()) + h10 * dy - h11 * other.dy,
              0.0));
    }
    return points;
  }
}
