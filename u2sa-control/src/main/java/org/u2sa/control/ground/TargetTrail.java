package org.u2sa.control.ground;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import java.util.Optional;
import org.u2sa.messages.frame.Point;

/**
 * Path traced by successive navigation points: from the vehicle's position at the first, through
 * the points it left behind, to the newest point. A point that moves ahead of the vehicle traces
 * the path; a fixed one gives a leg. Not thread-safe.
 */
final class TargetTrail {
  private static final double SPACING_M = 0.25;
  private static final int LONGEST = 512; // maximum number of vertices

  /**
   * Position relative to the path.
   *
   * @param rightM distance to the right of it [m]
   * @param headingRad heading of the path there, clockwise from north
   */
  record Beside(double rightM, double headingRad) {}

  private final Deque<Point> vertices = new ArrayDeque<>(); // north, east [m]
  private Point newest = Point.ORIGIN;

  /** Clears the path: the vehicle stands without a target. */
  void clear() {
    vertices.clear();
  }

  /** Updates the path with the newest target and the vehicle's position: north, east [m]. */
  void see(Point target, Point place) {
    if (vertices.isEmpty()) {
      vertices.add(place);
      newest = target;
      return;
    }
    if (newest.distanceTo(target) >= SPACING_M) {
      vertices.add(newest);
      newest = target;
      if (vertices.size() > LONGEST) {
        vertices.remove();
      }
    }
  }

  /** Nearest part of the path; empty if there is no path. Drops the parts behind it. */
  Optional<Beside> beside(Point place) {
    if (vertices.isEmpty()) {
      return Optional.empty();
    }
    Optional<Beside> nearest = Optional.empty();
    double least = Double.POSITIVE_INFINITY;
    int passed = 0;
    int index = 0;
    Iterator<Point> each = vertices.iterator();
    Point from = each.next();
    boolean isLast;
    do {
      isLast = !each.hasNext();
      Point to = isLast ? newest : each.next();
      double length = Math.hypot(to.x() - from.x(), to.y() - from.y());
      if (length > 0.0) {
        double north = (to.x() - from.x()) / length;
        double east = (to.y() - from.y()) / length;
        double along = (place.x() - from.x()) * north + (place.y() - from.y()) * east;
        double right = (place.y() - from.y()) * north - (place.x() - from.x()) * east;
        double beyond = along - Math.max(0.0, isLast ? along : Math.min(length, along));
        double distance = Math.hypot(beyond, right);
        if (distance <= least) { // on ties, the later segment
          least = distance;
          nearest = Optional.of(new Beside(right, Math.atan2(east, north)));
          passed = index;
        }
      }
      from = to;
      index++;
    } while (!isLast);
    for (int i = 0; i < passed; i++) {
      vertices.remove();
    }
    return nearest;
  }
}
