package org.u2sa.scenarios.igvc;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.PolyLine;
import org.u2sa.sim.camera.Scenery;

/**
 * Checks a course against the rules, using only its objects, regardless of its source: lanes of 10
 * to 20 ft, turn radii of at least 5 ft, everything on the field, nothing on the wrong side of a
 * line, and a passage of 5 ft from the start past every waypoint. Distances are computed from the
 * objects' exact shapes.
 */
final class CourseChecker {
  static final double PASSAGE_M = 1.524; // 5 ft
  private static final double MIN_LANE_M = 3.048; // 10 ft
  private static final double MAX_LANE_M = 6.096; // 20 ft
  private static final double MIN_TURN_M = 1.524;
  private static final double AREA_M = 48.0; // diagonal of 120 ft by 100 ft
  private static final double CELL_M = 0.05;
  private static final double MARGIN_M = 3.0;
  private static final double ROUNDING_M = 0.005;
  private static final double ROUNDING = 1.0e-12; // collinear segments do not cross

  private final Course course;
  private final List<String> faults = new ArrayList<>();

  private CourseChecker(Course course) {
    this.course = course;
  }

  /** Rule violations of a course, one sentence each; empty if none. */
  static List<String> faults(Course course) {
    CourseChecker checker = new CourseChecker(course);
    checker.lanes();
    checker.field();
    checker.faults.addAll(RampRules.faults(course));
    if (checker.faults.isEmpty()) {
      checker.passages();
    }
    return checker.faults;
  }

  private void fault(String format, Object... values) {
    faults.add(String.format(java.util.Locale.ROOT, format, values));
  }

  private void field() {
    List<Point> all = new ArrayList<>();
    course.objects().forEach(object -> all.add(object.center()));
    course.boundaries().forEach(line -> all.addAll(line.points()));
    for (Point a : all) {
      for (Point b : all) {
        if (Math.hypot(a.x() - b.x(), a.y() - b.y()) > AREA_M) {
          fault("the course spans more than %.0f m", AREA_M);
          return;
        }
      }
    }
  }

  /** Checks that each boundary point is one lane width away from the opposite boundary. */
  private void lanes() {
    List<PolyLine> lines = course.boundaries();
    for (int i = 0; i < lines.size(); i++) {
      turns(lines.get(i));
      for (int j = i + 1; j < lines.size(); j++) {
        apart(lines.get(i), lines.get(j), i / 2 == j / 2);
      }
      crossings(lines.get(i), lines);
    }
  }

  private void turns(PolyLine line) {
    List<Point> points = line.points();
    int span = 4;
    for (int i = span; i + span < points.size(); i++) {
      double radius = radiusM(points.get(i - span), points.get(i), points.get(i + span));
      if (radius < MIN_TURN_M - 0.05) {
        fault("%s turns with a radius of %.2f m", line.uid(), radius);
        return;
      }
    }
  }

  /** Radius of the circle through three points: a b c / 4 A. */
  private static double radiusM(Point a, Point b, Point c) {
    double ab = Math.hypot(b.x() - a.x(), b.y() - a.y());
    double bc = Math.hypot(c.x() - b.x(), c.y() - b.y());
    double ca = Math.hypot(a.x() - c.x(), a.y() - c.y());
    double twice = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
    return twice == 0.0 ? Double.POSITIVE_INFINITY : ab * bc * ca / (2.0 * Math.abs(twice));
  }

  /** Checks the distance of both sides of a lane, or of lines of different lanes. */
  private void apart(PolyLine one, PolyLine other, boolean isLane) {
    for (Point point : one.points()) {
      double away = metres(point, other.points());
      if (isLane && (away < MIN_LANE_M - ROUNDING_M || away > MAX_LANE_M + ROUNDING_M)) {
        fault("the lane between %s and %s is %.2f m wide", one.uid(), other.uid(), away);
        return;
      }
      if (!isLane && away < 4.0 * Course.LINE_M) {
        fault("%s and %s are %.2f m apart", one.uid(), other.uid(), away);
        return;
      }
    }
  }

  private void crossings(PolyLine line, List<PolyLine> all) {
    for (PolyLine other : all) {
      for (int i = 1; i < line.points().size(); i++) {
        for (int j = 1; j < other.points().size(); j++) {
          boolean neighbours = line == other && Math.abs(i - j) <= 1;
          if (!neighbours
              && meets(
                  line.points().get(i - 1),
                  line.points().get(i),
                  other.points().get(j - 1),
                  other.points().get(j))) {
            fault("%s and %s cross", line.uid(), other.uid());
            return;
          }
        }
      }
    }
  }

  private static boolean meets(Point a, Point b, Point c, Point d) {
    return side(a, b, c) * side(a, b, d) < -ROUNDING && side(c, d, a) * side(c, d, b) < -ROUNDING;
  }

  private static double side(Point a, Point b, Point p) {
    return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
  }

  private static double metres(Point from, List<Point> line) {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 1; i < line.size(); i++) {
      least = Math.min(least, from.flatDistanceTo(line.get(i - 1), line.get(i)));
    }
    return least;
  }

  /**
   * Checks that a disc of the minimum passage width can move from the start past every waypoint in
   * order.
   */
  private void passages() {
    double[] bounds = bounds();
    int columns = (int) Math.ceil((bounds[2] - bounds[0]) / CELL_M);
    int rows = (int) Math.ceil((bounds[3] - bounds[1]) / CELL_M);
    boolean[] closed = new boolean[rows * columns];
    for (ObjectDescription object : course.objects()) {
      if (isInTheWay(object)) {
        close(object, closed, bounds, columns, rows);
      }
    }
    Course.Start start = course.start();
    double x = start.eastM();
    double y = start.northM();
    for (Course.Goal goal : course.goals()) {
      Optional<Point> there = reach(x, y, goal, closed, bounds, columns, rows);
      if (there.isEmpty()) {
        fault("no passage of %.3f m leads to %s", PASSAGE_M, goal.name());
        return;
      }
      x = there.get().x();
      y = there.get().y();
    }
  }

  /** Whether the vehicle must not touch the object. */
  static boolean isInTheWay(ObjectDescription object) {
    return switch (object.objectType()) {
      case Course.WAYPOINT, Course.START, Scenery.LINE, Scenery.WORN_LINE, Scenery.RAMP -> false;
      default -> true;
    };
  }

  private double[] bounds() {
    double[] bounds = {0.0, 0.0, 0.0, 0.0};
    List<Point> all = new ArrayList<>();
    course.objects().forEach(object -> all.add(object.center()));
    course.boundaries().forEach(line -> all.addAll(line.points()));
    for (Point point : all) {
      bounds[0] = Math.min(bounds[0], point.x() - MARGIN_M);
      bounds[1] = Math.min(bounds[1], point.y() - MARGIN_M);
      bounds[2] = Math.max(bounds[2], point.x() + MARGIN_M);
      bounds[3] = Math.max(bounds[3], point.y() + MARGIN_M);
    }
    return bounds;
  }

  private static void close(
      ObjectDescription object, boolean[] closed, double[] bounds, int columns, int rows) {
    double radius = 0.5 * PASSAGE_M;
    List<Point> spine = object instanceof PolyLine line ? line.points() : List.of(object.center());
    double reach = object instanceof PolyLine ? radius + 0.2 : radius + 2.0;
    for (int k = 0; k < spine.size(); k++) {
      Point a = spine.get(Math.max(0, k - 1));
      Point b = spine.get(k);
      int left = Math.max(0, (int) ((Math.min(a.x(), b.x()) - reach - bounds[0]) / CELL_M));
      int right =
          Math.min(columns - 1, (int) ((Math.max(a.x(), b.x()) + reach - bounds[0]) / CELL_M));
      int low = Math.max(0, (int) ((Math.min(a.y(), b.y()) - reach - bounds[1]) / CELL_M));
      int high = Math.min(rows - 1, (int) ((Math.max(a.y(), b.y()) + reach - bounds[1]) / CELL_M));
      for (int row = low; row <= high; row++) {
        for (int column = left; column <= right; column++) {
          Point at =
              Point.of(bounds[0] + column * CELL_M, bounds[1] + row * CELL_M, object.center().z());
          double away =
              object instanceof PolyLine line
                  ? at.flatDistanceTo(a, b) - 0.5 * line.width()
                  : object.distanceTo(at);
          closed[row * columns + column] |= away < radius;
        }
      }
    }
  }

  /** Reachable position within the goal, preferring the one nearest to its centre. */
  private static Optional<Point> reach(
      double x,
      double y,
      Course.Goal goal,
      boolean[] closed,
      double[] bounds,
      int columns,
      int rows) {
    int begin =
        (int) Math.round((y - bounds[1]) / CELL_M) * columns
            + (int) Math.round((x - bounds[0]) / CELL_M);
    boolean[] seen = new boolean[closed.length];
    Deque<Integer> next = new ArrayDeque<>();
    if (!closed[begin]) {
      seen[begin] = true;
      next.add(begin);
    }
    double least = goal.radiusM();
    Optional<Point> found = Optional.empty();
    int[] steps = {-1, 1, -columns, columns};
    while (!next.isEmpty()) {
      int cell = next.poll();
      double cx = bounds[0] + cell % columns * CELL_M;
      double cy = bounds[1] + cell / columns * CELL_M;
      double away = Math.hypot(cx - goal.eastM(), cy - goal.northM());
      if (away <= least) {
        least = away;
        found = Optional.of(Point.of(cx, cy, 0.0));
      }
      for (int step : steps) {
        int to = cell + step;
        boolean wraps = Math.abs(to % columns - cell % columns) > 1;
        if (to >= 0 && to < closed.length && !wraps && !closed[to] && !seen[to]) {
          seen[to] = true;
          next.add(to);
        }
      }
    }
    return found;
  }
}
