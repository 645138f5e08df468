package org.u2sa.messages.shape;

import java.util.List;
import org.u2sa.messages.Metric;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/** Distances [m] to shapes around the origin, 0 inside. */
final class Shapes {
  private Shapes() {}

  /** To an upright solid cylinder, or to a disc if its height is 0. */
  static double toDisc(Point p, double radius, double height) {
    double outside = Math.max(0.0, Math.hypot(p.x(), p.y()) - radius);
    return Math.hypot(outside, beyond(p.z(), height));
  }

  /** To an upright box of length, width and height, turned by psi. */
  static double toBox(ReferenceFrame frame, Point p, double psi, Point size) {
    // Length axis in the frame's x-y plane: GLOBAL and UTM count psi clockwise from y (north), the
    // others from x towards y.
    double along = frame.isEarth() ? Math.PI / 2.0 - psi : psi;
    double cos = Math.cos(along);
    double sin = Math.sin(along);
    double lengthwise = beyond(p.x() * cos + p.y() * sin, size.x());
    double crosswise = beyond(p.y() * cos - p.x() * sin, size.y());
    return Point.of(lengthwise, crosswise, beyond(p.z(), size.z())).distance();
  }

  private static double beyond(double coordinate, double size) {
    return Math.max(0.0, Math.abs(coordinate) - size / 2.0);
  }

  /** To the nearest of some points; to the centre if there is none. */
  static double toNearest(Metric metric, List<Point> points, Point from) {
    Point p = metric.metres(from);
    double nearest = Double.POSITIVE_INFINITY;
    for (Point point : points) {
      nearest = Math.min(nearest, metric.metres(point).distanceTo(p));
    }
    return points.isEmpty() ? p.distance() : nearest;
  }

  /** To the nearest point of a line through points in order; to the centre if there is none. */
  static double toPolyline(Metric metric, List<Point> points, Point from) {
    Point p = metric.metres(from);
    double nearest = toNearest(metric, points, from);
    for (int i = 1; i < points.size(); i++) {
      Point start = metric.metres(points.get(i - 1));
      nearest = Math.min(nearest, toSegment(start, metric.metres(points.get(i)), p));
    }
    return nearest;
  }

  private static double toSegment(Point start, Point end, Point p) {
    Point way = end.minus(start);
    Point offset = p.minus(start);
    double squared = dot(way, way);
    double share = squared == 0.0 ? 0.0 : Math.max(0.0, Math.min(1.0, dot(offset, way) / squared));
    return Point.of(
            offset.x() - share * way.x(),
            offset.y() - share * way.y(),
            offset.z() - share * way.z())
        .distance();
  }

  private static double dot(Point a, Point b) {
    return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
  }
}
