package org.u2sa.vision.lane;

import java.util.List;
import org.u2sa.messages.frame.Point;

/** Geometry of lines given as points spaced about {@link LineSamples#STEP_M} [m]. */
final class LineGeometry {
  private static final double TANGENT_M = 0.8; // distance to either side for measuring a direction

  private LineGeometry() {}

  static double metres(Point a, Point b) {
    double x = a.x() - b.x();
    double y = a.y() - b.y();
    return Math.sqrt(x * x + y * y); // hypot is ten times slower
  }

  /** Whether two points are closer than a distance [m]. */
  static boolean isWithin(double metres, Point a, Point b) {
    return Math.abs(a.x() - b.x()) < metres && metres(a, b) < metres;
  }

  static double lengthM(List<Point> line) {
    double length = 0.0;
    for (int i = 1; i < line.size(); i++) {
      length += metres(line.get(i - 1), line.get(i));
    }
    return length;
  }

  /** Index of the line point nearest to a position. */
  static int nearest(Point place, List<Point> line) {
    int nearest = 0;
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < line.size(); i++) {
      if (isWithin(least, place, line.get(i))) {
        least = metres(place, line.get(i));
        nearest = i;
      }
    }
    return nearest;
  }

  /** Direction of a line at one of its points, as a unit vector. */
  static double[] direction(List<Point> line, int at) {
    int span = (int) Math.round(TANGENT_M / LineSamples.STEP_M);
    Point from = line.get(Math.max(0, at - span));
    Point to = line.get(Math.min(line.size() - 1, at + span));
    double length = Math.max(1.0e-9, metres(from, to));
    return new double[] {(to.x() - from.x()) / length, (to.y() - from.y()) / length};
  }

  /**
   * Distance of a position from a line at one of its points, positive to the left of the direction.
   */
  static double leftM(Point place, List<Point> line, int at) {
    double[] way = direction(line, at);
    return way[0] * (place.y() - line.get(at).y()) - way[1] * (place.x() - line.get(at).x());
  }
}
