package org.u2sa.scenarios.igvc;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.messages.frame.Point;

/** Centre line of a lane as dense points, with the lane width at each. */
final class Centreline {
  static final double STEP_M = 0.1;

  private final List<Point> points = new ArrayList<>(); // x, y, heading from x towards y [rad]
  private final List<Double> widths = new ArrayList<>();
  private double lengthM;

  void add(double x, double y, double headingRad, double widthM) {
    if (!points.isEmpty()) {
      Point last = points.get(points.size() - 1);
      lengthM += Math.hypot(x - last.x(), y - last.y());
    }
    points.add(Point.of(x, y, headingRad));
    widths.add(widthM);
  }

  int count() {
    return points.size();
  }

  double lengthM() {
    return lengthM;
  }

  double widthM(int at) {
    return widths.get(at);
  }

  /** Heading of the lane at a point [rad from x towards y]. */
  double headingRad(int at) {
    return points.get(at).z();
  }

  /** Position beside a point, left positive [m]. */
  Point beside(int at, double leftM) {
    Point middle = points.get(at);
    return Point.of(
        middle.x() - leftM * StrictMath.sin(middle.z()),
        middle.y() + leftM * StrictMath.cos(middle.z()),
        0.0);
  }

  /** Edge of a section of the lane: side 1 left, −1 right. */
  List<Point> edge(int from, int to, int side) {
    List<Point> edge = new ArrayList<>();
    for (int i = from; i <= to; i += 2) {
      edge.add(beside(i, side * 0.5 * widths.get(i)));
    }
    if ((to - from) % 2 != 0) {
      edge.add(beside(to, side * 0.5 * widths.get(to)));
    }
    return edge;
  }

  /** First point at least this distance along the centre line from a point; the last if none. */
  int along(int from, double metres) {
    return Math.min(points.size() - 1, from + (int) Math.ceil(metres / STEP_M));
  }

  /** Same along the lane's edge (side 1 left, −1 right), whose length differs in bends. */
  int alongEdge(int from, int side, double metres) {
    int at = from;
    double gone = 0.0;
    while (gone < metres && at < points.size() - 1) {
      Point here = beside(at, side * 0.5 * widths.get(at));
      at++;
      Point next = beside(at, side * 0.5 * widths.get(at));
      gone += Math.hypot(next.x() - here.x(), next.y() - here.y());
    }
    return at;
  }
}
