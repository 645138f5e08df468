package org.u2sa.vision.lane;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import org.u2sa.messages.frame.Point;

/**
 * The vehicle's recent path. Two lines between which it has driven are the sides of its lane;
 * others may belong to adjacent lanes. Coordinates in metres from the map's anchor.
 */
final class DrivenWay {
  private static final double STEP_M = 0.3;
  private static final int MOST = 200; // positions, i.e. 60 m

  private final Deque<Point> places = new ArrayDeque<>();

  void clear() {
    places.clear();
  }

  void at(Point place) {
    Point last = places.peekLast();
    if (last == null || Math.hypot(place.x() - last.x(), place.y() - last.y()) >= STEP_M) {
      places.addLast(place);
      if (places.size() > MOST) {
        places.removeFirst();
      }
    }
  }

  boolean passesBetween(Point a, Point b) {
    Iterator<Point> each = places.iterator();
    Point from = each.hasNext() ? each.next() : null;
    while (each.hasNext()) {
      Point to = each.next();
      if (side(a, b, from) * side(a, b, to) < 0.0 && side(from, to, a) * side(from, to, b) < 0.0) {
        return true;
      }
      from = to;
    }
    return false;
  }

  /** Positive if a point lies left of the line from one point to another. */
  private static double side(Point from, Point to, Point place) {
    return (to.x() - from.x()) * (place.y() - from.y())
        - (to.y() - from.y()) * (place.x() - from.x());
  }
}
