package org.u2sa.core.control.ground;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import java.util.Optional;
import org.u2sa.messages.frame.Point;

/**
 * The path that navigation points describe one after the other: from where the vehicle was at the
 * first, over those it left behind, to the newest. A point that moves ahead of the vehicle draws
 * the path; one that stays until it is reached gives a leg. For one thread.
 */
final class TargetTrail {
  private static final double SPACING_M = 0.25;
  private static final int LONGEST = 512; // vertices

  /**
   * Where a place lies beside the path.
   *
   * @param rightM to the right of it [m]
   * @param headingRad of the path there, clockwise from north
   */
  record Beside(double rightM, double headingRad) {}

  private final Deque<Point> vertices = new ArrayDeque<>(); // north, east [m]
  private Point newest = Point.ORIGIN;

  /** Forgets the path: the vehicle stands without a target. */
  void clear() {
    vertices.clear();
  }

  /** Takes note of the newest target, seen from a place: north, east [m]. */
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

  /** The nearest part of the path; empty if there is none. What lies behind it is forgotten. */
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
        if (distance <= least) { // of equal ones the later
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
