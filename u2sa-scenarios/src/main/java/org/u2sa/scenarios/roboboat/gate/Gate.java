package org.u2sa.scenarios.roboboat.gate;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.messages.frame.Point;

/**
 * A gate between two buoys on a level plane with axes north and east [m].
 *
 * @param left buoy to port of a passing boat
 * @param right buoy to starboard
 */
public record Gate(Point left, Point right) {
  private static final double NARROWEST_M = 1.5;
  private static final double WIDEST_M = 4.0;

  /** Gates of two colours: each left buoy with its nearest right one, if unambiguous. */
  public static List<Gate> among(List<Point> lefts, List<Point> rights) {
    List<Gate> gates = new ArrayList<>();
    for (Point left : lefts) {
      Point partner = nearest(left, rights);
      if (partner != null && nearest(partner, lefts).equals(left)) {
        double width = left.flatDistanceTo(partner);
        if (width >= NARROWEST_M && width <= WIDEST_M) {
          gates.add(new Gate(left, partner));
        }
      }
    }
    return gates;
  }

  private static Point nearest(Point to, List<Point> among) {
    Point nearest = null;
    for (Point each : among) {
      if (nearest == null || to.flatDistanceTo(each) < to.flatDistanceTo(nearest)) {
        nearest = each;
      }
    }
    return nearest;
  }

  /** Half its width, between the centres of its buoys [m]. */
  public double halfM() {
    return left.flatDistanceTo(right) / 2.0;
  }

  public Point middle() {
    return Point.of((left.x() + right.x()) / 2.0, (left.y() + right.y()) / 2.0, 0.0);
  }

  /** Unit vector of the way through. */
  public Point way() {
    double width = left.flatDistanceTo(right);
    return Point.of((right.y() - left.y()) / width, (left.x() - right.x()) / width, 0.0);
  }

  /** Distance to go to the gate along its axis [m]; negative beyond it. */
  public double aheadM(Point from) {
    Point way = way();
    Point middle = middle();
    return (middle.x() - from.x()) * way.x() + (middle.y() - from.y()) * way.y();
  }

  /** Distance from the gate's axis, positive to the right [m]. */
  public double asideM(Point from) {
    Point way = way();
    Point middle = middle();
    return (from.y() - middle.y()) * way.x() - (from.x() - middle.x()) * way.y();
  }

  /** Point on its axis at this distance beyond the gate [m]. */
  public Point beyond(double metres) {
    Point way = way();
    Point middle = middle();
    return Point.of(middle.x() + metres * way.x(), middle.y() + metres * way.y(), 0.0);
  }

  /** Whether a movement passes through the gate in its direction. */
  public boolean isPassed(Point before, Point now) {
    double from = aheadM(before);
    double to = aheadM(now);
    if (!(from > 0.0 && to <= 0.0)) {
      return false;
    }
    double share = from / (from - to);
    double aside = asideM(before) + share * (asideM(now) - asideM(before));
    return Math.abs(aside) < halfM();
  }
}
