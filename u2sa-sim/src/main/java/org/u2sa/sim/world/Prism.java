package org.u2sa.sim.world;

import org.u2sa.messages.frame.Point;

/** An upright prism over a convex polygon in world axes, for contact tests. */
record Prism(double[] x, double[] y, double low, double high) {
  /** Its bounding box. */
  Bounds bounds() {
    double west = x[0];
    double south = y[0];
    double east = x[0];
    double north = y[0];
    for (int i = 1; i < x.length; i++) {
      west = Math.min(west, x[i]);
      south = Math.min(south, y[i]);
      east = Math.max(east, x[i]);
      north = Math.max(north, y[i]);
    }
    return new Bounds(west, south, low, east, north, high);
  }

  /** Whether the bottom is below the ground at a corner or at the given position within it. */
  boolean isBelow(Terrain ground, Point within) {
    boolean below = low < ground.heightM(within.x(), within.y());
    for (int i = 0; i < x.length && !below; i++) {
      below = low < ground.heightM(x[i], y[i]);
    }
    return below;
  }

  /** Vertical gap to a span from {@code bottom} to {@code top} [m]; 0 if they overlap in height. */
  double verticalM(double bottom, double top) {
    return Math.max(0.0, Math.max(bottom - high, low - top));
  }

  /** Horizontal distance from a point to the polygon [m]; 0 inside. */
  double distanceM(double px, double py) {
    double nearest = Double.POSITIVE_INFINITY;
    int left = 0;
    int right = 0;
    for (int i = 0; i < x.length; i++) {
      int j = (i + 1) % x.length;
      double wayX = x[j] - x[i];
      double wayY = y[j] - y[i];
      double cross = wayX * (py - y[i]) - wayY * (px - x[i]);
      left += cross >= 0.0 ? 1 : 0;
      right += cross <= 0.0 ? 1 : 0;
      double share = ((px - x[i]) * wayX + (py - y[i]) * wayY) / (wayX * wayX + wayY * wayY);
      double bounded = Math.max(0.0, Math.min(1.0, share));
      nearest =
          Math.min(nearest, Math.hypot(px - x[i] - bounded * wayX, py - y[i] - bounded * wayY));
    }
    return left == x.length || right == x.length ? 0.0 : nearest;
  }

  /** Whether a line segment intersects the prism. */
  boolean meets(double ax, double ay, double az, double bx, double by, double bz) {
    double[] span = {0.0, 1.0}; // remaining part of the segment
    boolean inside = keep(span, high - az, az - bz) && keep(span, az - low, bz - az);
    double turn = Math.signum(area());
    for (int i = 0; inside && i < x.length; i++) {
      int j = (i + 1) % x.length;
      double outX = turn * (y[j] - y[i]);
      double outY = -turn * (x[j] - x[i]);
      double within = outX * (x[i] - ax) + outY * (y[i] - ay);
      inside = keep(span, within, -outX * (bx - ax) - outY * (by - ay));
    }
    return inside;
  }

  /** Clips the span to where {@code start + change · share} ≥ 0; false if nothing remains. */
  private static boolean keep(double[] span, double start, double change) {
    if (change == 0.0) {
      return start >= 0.0;
    }
    double zero = -start / change;
    if (change > 0.0) {
      span[0] = Math.max(span[0], zero);
    } else {
      span[1] = Math.min(span[1], zero);
    }
    return span[0] <= span[1];
  }

  private double area() {
    double twice = 0.0;
    for (int i = 0; i < x.length; i++) {
      int j = (i + 1) % x.length;
      twice += (x[i] - x[0]) * (y[j] - y[0]) - (x[j] - x[0]) * (y[i] - y[0]);
    }
    return twice;
  }

  /** Whether both polygons overlap (separating-axis test). */
  boolean overlaps(Prism other) {
    return !parts(other) && !other.parts(this);
  }

  private boolean parts(Prism other) {
    for (int i = 0; i < x.length; i++) {
      int j = (i + 1) % x.length;
      double acrossX = y[i] - y[j];
      double acrossY = x[j] - x[i];
      if (reach(acrossX, acrossY) < -other.reach(-acrossX, -acrossY)
          || other.reach(acrossX, acrossY) < -reach(-acrossX, -acrossY)) {
        return true;
      }
    }
    return false;
  }

  /** Maximum extent along a direction. */
  private double reach(double alongX, double alongY) {
    double farthest = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < x.length; i++) {
      farthest = Math.max(farthest, x[i] * alongX + y[i] * alongY);
    }
    return farthest;
  }
}
