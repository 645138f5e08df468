package org.u2sa.messages.shape;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.u2sa.messages.frame.Point;

/**
 * Counts sides of areas that are near each other. Buffering the borders costs about 30 µs, and
 * memory, for each pair of sides closer than twice the buffer distance; areas with too many such
 * pairs are therefore detected first.
 */
public final class NearSides {
  private static final long MAX_COMPARED = 10_000_000; // about 0.1 s

  private NearSides() {}

  /**
   * Number of pairs closer to each other than a distance. Stops at more than the limit, and returns
   * more than the limit if too many pairs would have to be compared. Pairs within one convex border
   * are not counted; pairs of two convex borders are counted only if they cross.
   *
   * @param borders corners of closed borders, in order [m]; z is ignored
   */
  public static int count(List<List<Point>> borders, double distanceM, int limit) {
    List<Side> sides = new ArrayList<>();
    for (int border = 0; border < borders.size(); border++) {
      List<Point> corners = borders.get(border);
      boolean isConvex = isConvex(corners);
      for (int i = 0; i < corners.size(); i++) {
        Point to = corners.get((i + 1) % corners.size());
        sides.add(new Side(corners.get(i), to, border, isConvex));
      }
    }
    sides.sort(Comparator.comparingDouble(Side::west));
    int pairs = 0;
    long compared = 0;
    for (int i = 0; i < sides.size() && pairs <= limit; i++) {
      Side side = sides.get(i);
      double until = side.east() + distanceM;
      for (int k = i + 1; k < sides.size() && sides.get(k).west() < until; k++) {
        pairs += side.isNear(sides.get(k), distanceM) ? 1 : 0;
        if (++compared > MAX_COMPARED) {
          return limit + 1;
        }
      }
    }
    return pairs;
  }

  private static boolean isConvex(List<Point> corners) {
    int left = 0;
    int right = 0;
    for (int i = 0; i < corners.size(); i++) {
      Point next = corners.get((i + 1) % corners.size());
      double turn = turn(corners.get(i), next, corners.get((i + 2) % corners.size()));
      left += turn > 0.0 ? 1 : 0;
      right += turn < 0.0 ? 1 : 0;
    }
    return left == 0 || right == 0;
  }

  private static double turn(Point a, Point b, Point c) {
    return (b.x() - a.x()) * (c.y() - b.y()) - (b.y() - a.y()) * (c.x() - b.x());
  }

  private record Side(Point from, Point to, int border, boolean isConvex) {
    double west() {
      return Math.min(from.x(), to.x());
    }

    double east() {
      return Math.max(from.x(), to.x());
    }

    boolean isNear(Side other, double distanceM) {
      boolean areConvex = isConvex && other.isConvex;
      if (areConvex && border == other.border) {
        return false;
      }
      double south = Math.min(from.y(), to.y()) - distanceM;
      double north = Math.max(from.y(), to.y()) + distanceM;
      if (Math.max(other.from.y(), other.to.y()) < south
          || Math.min(other.from.y(), other.to.y()) > north) {
        return false;
      }
      return crosses(other)
          || !areConvex
              && (toward(other.from) < distanceM
                  || toward(other.to) < distanceM
                  || other.toward(from) < distanceM
                  || other.toward(to) < distanceM);
    }

    private boolean crosses(Side other) {
      return turn(from, to, other.from) * turn(from, to, other.to) < 0.0
          && turn(other.from, other.to, from) * turn(other.from, other.to, to) < 0.0;
    }

    private double toward(Point place) {
      double dx = to.x() - from.x();
      double dy = to.y() - from.y();
      double square = dx * dx + dy * dy;
      double along = (place.x() - from.x()) * dx + (place.y() - from.y()) * dy;
      double share = square == 0.0 ? 0.0 : Math.max(0.0, Math.min(1.0, along / square));
      return Math.hypot(place.x() - from.x() - share * dx, place.y() - from.y() - share * dy);
    }
  }
}
