package org.u2sa.sim.world;

/** An axis-aligned bounding box. */
record Bounds(double x0, double y0, double z0, double x1, double y1, double z1) {
  /** The empty box. */
  static final Bounds NONE =
      new Bounds(
          Double.POSITIVE_INFINITY,
          Double.POSITIVE_INFINITY,
          Double.POSITIVE_INFINITY,
          Double.NEGATIVE_INFINITY,
          Double.NEGATIVE_INFINITY,
          Double.NEGATIVE_INFINITY);

  private static final double ROUNDING = 1e-9; // exceeds the rounding error at a face [m]

  /** Box around a point, extending this far to each side. */
  static Bounds around(double x, double y, double z, double flatM, double upM) {
    return new Bounds(x - flatM, y - flatM, z - upM, x + flatM, y + flatM, z + upM);
  }

  /** Union of both boxes. */
  Bounds and(Bounds b) {
    return new Bounds(
        Math.min(x0, b.x0),
        Math.min(y0, b.y0),
        Math.min(z0, b.z0),
        Math.max(x1, b.x1),
        Math.max(y1, b.y1),
        Math.max(z1, b.z1));
  }

  boolean overlaps(Bounds b) {
    return x0 <= b.x1 && b.x0 <= x1 && y0 <= b.y1 && b.y0 <= y1 && z0 <= b.z1 && b.z0 <= z1;
  }

  /** Distance along the ray to its entry; infinite for a miss. */
  double enteredM(Ray ray) {
    double in = Math.max(0.0, first(ray.x(), ray.dx(), x0, x1));
    double out = last(ray.x(), ray.dx(), x0, x1);
    if (in > out) {
      return Double.POSITIVE_INFINITY; // early exit for the common case
    }
    in = Math.max(in, first(ray.y(), ray.dy(), y0, y1));
    out = Math.min(out, last(ray.y(), ray.dy(), y0, y1));
    if (in > out) {
      return Double.POSITIVE_INFINITY;
    }
    in = Math.max(in, first(ray.z(), ray.dz(), z0, z1));
    out = Math.min(out, last(ray.z(), ray.dz(), z0, z1));
    return in <= out ? in : Double.POSITIVE_INFINITY;
  }

  private static double first(double start, double change, double low, double high) {
    if (change == 0.0) {
      return isBetween(start, low, high) ? 0.0 : Double.POSITIVE_INFINITY;
    }
    return change > 0.0 ? (low - ROUNDING - start) / change : (high + ROUNDING - start) / change;
  }

  private static double last(double start, double change, double low, double high) {
    if (change == 0.0) {
      return isBetween(start, low, high) ? Double.POSITIVE_INFINITY : -1.0;
    }
    return change > 0.0 ? (high + ROUNDING - start) / change : (low - ROUNDING - start) / change;
  }

  private static boolean isBetween(double value, double low, double high) {
    return value >= low - ROUNDING && value <= high + ROUNDING;
  }

  /** Clips a span of a line to the interval of one coordinate; false if nothing remains. */
  static boolean cut(double[] span, double start, double change, double low, double high) {
    if (change == 0.0) {
      return start >= low && start <= high;
    }
    double one = (low - start) / change;
    double other = (high - start) / change;
    span[0] = Math.max(span[0], Math.min(one, other));
    span[1] = Math.min(span[1], Math.max(one, other));
    return span[0] <= span[1];
  }
}
