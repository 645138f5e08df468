package org.u2sa.sim.marine;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.u2sa.messages.frame.Point;

/**
 * A convex polygon in the plane of east and north [m].
 *
 * @param corners anticlockwise
 */
record ConvexOutline(List<Point> corners) {
  /** The polygon of these corners, given in clockwise or anticlockwise order. */
  static ConvexOutline of(List<Point> corners) {
    double turn = cross(corners.get(0), corners.get(1), corners.get(2));
    List<Point> ordered = new ArrayList<>(corners);
    if (turn < 0.0) {
      Collections.reverse(ordered);
    }
    return new ConvexOutline(List.copyOf(ordered));
  }

  private static double cross(Point a, Point b, Point c) {
    return (b.x() - a.x()) * (c.y() - b.y()) - (b.y() - a.y()) * (c.x() - b.x());
  }

  /** Shortest displacement out of the polygon; empty for a point outside. */
  Optional<Point> wayOut(Point place) {
    double least = Double.POSITIVE_INFINITY;
    Point out = Point.ORIGIN;
    for (int i = 0; i < corners.size(); i++) {
      Point from = corners.get(i);
      Point side = corners.get((i + 1) % corners.size()).minus(from);
      double length = side.distance();
      double depth =
          (side.x() * (place.y() - from.y()) - side.y() * (place.x() - from.x())) / length;
      if (depth <= 0.0) {
        return Optional.empty();
      }
      if (depth < least) {
        least = depth;
        out = Point.of(side.y(), -side.x(), 0.0).times(depth / length);
      }
    }
    return Optional.of(out);
  }
}
