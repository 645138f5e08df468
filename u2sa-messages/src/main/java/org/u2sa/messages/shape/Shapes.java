package org.u2sa.messages.shape;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.messages.Metric;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/** Distances [m] to shapes around the origin, 0 inside. */
final class Shapes {
  private Shapes() {}

  /** Distance to an upright solid cylinder, or to a disc if its height is 0. */
  static double toDisc(Point p, double radius, double height) {
    double outside = Math.max(0.0, Math.hypot(p.x(), p.y()) - radius);
    return Math.hypot(outside, beyond(p.z(), height));
  }

  /** Distance to an upright box of length, width and height, rotated by psi. */
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

  /** Distance to the nearest of several points; to the centre without points. */
  static double toNearest(Metric metric, List<Point> points, Point from) {
    Point p = metric.metres(from);
    double nearest = Double.POSITIVE_INFINITY;
    for (Point point : points) {
      nearest = Math.min(nearest, metric.metres(point).distanceTo(p));
    }
    return points.isEmpty() ? p.distance() : nearest;
  }

  /** Distance to a polyline; to the centre if it has no points. */
  static double toPolyline(Metric metric, List<Point> points, Point from) {
    Point p = metric.metres(from);
    double nearest = toNearest(metric, points, from);
    for (int i = 1; i < points.size(); i++) {
      Point start = metric.metres(points.get(i - 1));
      nearest = Math.min(nearest, toSegment(start, metric.metres(points.get(i)), p));
    }
    return nearest;
  }

  /** Distance to an upright prism over a polygon, or to the polygon if its height is 0. */
  static double toPolygon(Metric metric, List<Point> points, double height, Point from) {
    Point p = metric.metres(from);
    List<Point> corners = flat(metric, points);
    double outside = corners.size() > 2 && isInside(corners, p) ? 0.0 : toOutline(corners, p, true);
    return Math.hypot(outside, beyond(p.z(), height));
  }

  /** Distance to an upright band along a polyline, of width y and height z. */
  static double toBand(Metric metric, List<Point> points, Point size, Point from) {
    Point p = metric.metres(from);
    double outside = Math.max(0.0, toOutline(flat(metric, points), p, false) - size.y() / 2.0);
    return Math.hypot(outside, beyond(p.z(), size.z()));
  }

  private static List<Point> flat(Metric metric, List<Point> points) {
    List<Point> flat = new ArrayList<>(points.size());
    for (Point point : points) {
      flat.add(level(metric.metres(point)));
    }
    return flat;
  }

  private static Point level(Point p) {
    return Point.of(p.x(), p.y(), 0.0);
  }

  /** Distance in the x-y plane; to the centre if there are no points. */
  private static double toOutline(List<Point> points, Point from, boolean closed) {
    Point p = level(from);
    if (points.isEmpty()) {
      return p.distance();
    }
    double nearest = points.get(0).distanceTo(p);
    for (int i = closed ? 0 : 1; i < points.size(); i++) {
      Point start = points.get(i == 0 ? points.size() - 1 : i - 1);
      nearest = Math.min(nearest, toSegment(start, points.get(i), p));
    }
    return nearest;
  }

  /** True if a ray along x crosses an odd number of edges. */
  private static boolean isInside(List<Point> corners, Point p) {
    boolean inside = false;
    Point a = corners.get(corners.size() - 1);
    for (Point b : corners) {
      if (a.y() > p.y() != b.y() > p.y()
          && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
        inside = !inside;
      }
      a = b;
    }
    return inside;
  }

  private static double toSegment(Point start, Point end, Point p) {
    Point way = end.minus(start);
    Point offset = p.minus(start);
    double squared = way.dot(way);
    double share = squared == 0.0 ? 0.0 : Math.max(0.0, Math.min(1.0, offset.dot(way) / squared));
    return offset.minus(way.times(share)).distance();
  }
}
