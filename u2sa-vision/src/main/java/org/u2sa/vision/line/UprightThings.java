package org.u2sa.vision.line;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.messages.frame.Point;

/**
 * Removes the parts of a traced line that run radially away from the camera. Poles and posts look
 * like paint in the bird's-eye view and always run radially; paint does so only if its line passes
 * below the camera. Lines that start close ahead, where a pole would be about to be hit, are kept
 * as paint.
 */
final class UprightThings {
  private static final int REACH = 3; // points to each side for measuring the direction
  private static final double RADIAL = 0.07; // sine of the maximum angle of a radial line
  private static final double SHORTEST_M = 0.4; // shorter parts may be tangents of a bend
  private static final double CLOSE = 2.5; // max. distance of a line's start, in camera heights
  private static final double AHEAD_M = 0.3; // maximum distance to each side

  private UprightThings() {}

  /**
   * Parts of a line that lie on the ground.
   *
   * @param points LEVEL, in order
   * @param camera camera position, LEVEL
   */
  static List<List<Point>> cutOut(List<Point> points, Point camera) {
    List<List<Point>> parts = new ArrayList<>();
    List<Point> part = new ArrayList<>();
    int at = 0;
    while (at < points.size()) {
      int end = at;
      double away = 0.0;
      while (end < points.size() && isRadial(points, end, camera)) {
        away += end > at ? points.get(end).distanceTo(points.get(end - 1)) : 0.0;
        end++;
      }
      boolean stands =
          away >= SHORTEST_M
              && !isCloseAhead(points.get(at), camera)
              && !isCloseAhead(points.get(end - 1), camera);
      if (stands) {
        add(part, parts);
        part = new ArrayList<>();
        at = end;
      } else {
        int last = Math.max(at + 1, end);
        part.addAll(points.subList(at, last));
        at = last;
      }
    }
    add(part, parts);
    return parts;
  }

  private static void add(List<Point> part, List<List<Point>> parts) {
    if (part.size() > 1) {
      parts.add(part);
    }
  }

  private static boolean isCloseAhead(Point end, Point camera) {
    double x = end.x() - camera.x();
    double y = end.y() - camera.y();
    return Math.abs(y) < AHEAD_M && Math.hypot(x, y) < CLOSE * Math.abs(camera.z() - end.z());
  }

  private static boolean isRadial(List<Point> points, int at, Point camera) {
    Point from = points.get(Math.max(0, at - REACH));
    Point to = points.get(Math.min(points.size() - 1, at + REACH));
    Point here = points.get(at);
    double x = here.x() - camera.x();
    double y = here.y() - camera.y();
    double alongX = to.x() - from.x();
    double alongY = to.y() - from.y();
    double product = Math.hypot(x, y) * Math.hypot(alongX, alongY);
    return Math.abs(x * alongY - y * alongX) < RADIAL * product;
  }
}
