package org.u2sa.vision.line;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.messages.frame.Point;

/**
 * Cuts out of a traced line what runs straight away from the camera. Poles and posts look like
 * paint from above, and always run so; paint does only where its line leads through below the
 * camera. What begins close ahead, where no pole can be but one that is about to be hit, is paint.
 */
final class UprightThings {
  private static final int REACH = 3; // points to each side, over which a direction is measured
  private static final double RADIAL = 0.07; // sine of the angle up to which it is away
  private static final double SHORTEST_M = 0.4; // what is shorter may be a bend's tangent
  private static final double CLOSE = 2.5; // heights of the camera, to where a line begins
  private static final double AHEAD_M = 0.3; // to each side

  private UprightThings() {}

  /**
   * The parts of a line that lie on the ground.
   *
   * @param points LEVEL, in order
   * @param camera the same, above the ground
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
