package org.u2sa.world.sdf;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.u2sa.messages.frame.Point;

/** The convex outline of points seen from above: Andrew's monotone chain. */
final class ConvexHull {
  private ConvexHull() {}

  /** Corners of the outline, anticlockwise; fewer than three if it has no area. */
  static List<Point> of(List<Point> points) {
    List<Point> sorted = new ArrayList<>(points);
    sorted.sort(Comparator.comparingDouble(Point::x).thenComparingDouble(Point::y));
    List<Point> hull = new ArrayList<>();
    for (Point point : sorted) {
      append(hull, point, 1);
    }
    int lower = hull.size();
    for (int i = sorted.size() - 2; i >= 0; i--) {
      append(hull, sorted.get(i), lower);
    }
    if (!hull.isEmpty()) {
      hull.remove(hull.size() - 1); // the first again
    }
    return hull;
  }

  private static void append(List<Point> hull, Point next, int kept) {
    while (hull.size() > kept && !turnsLeft(hull, next)) {
      hull.remove(hull.size() - 1);
    }
    hull.add(next);
  }

  private static boolean turnsLeft(List<Point> hull, Point c) {
    Point a = hull.get(hull.size() - 2);
    Point b = hull.get(hull.size() - 1);
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()) > 0.0;
  }
}
