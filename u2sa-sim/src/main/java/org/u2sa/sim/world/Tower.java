package org.u2sa.sim.world;

import java.util.Arrays;
import java.util.List;
import org.u2sa.messages.frame.Point;

/** An upright prism over any polygon (even-odd rule); without height, a level area. */
record Tower(double[] x, double[] y, double low, double high) implements Obstacle {
  /**
   * Creates a prism.
   *
   * @param corners corners in order; their z is ignored
   * @param z height of its middle [m]
   */
  static Tower of(List<Point> corners, double z, double heightM) {
    return new Tower(
        corners.stream().mapToDouble(Point::x).toArray(),
        corners.stream().mapToDouble(Point::y).toArray(),
        z - heightM / 2.0,
        z + heightM / 2.0);
  }

  @Override
  public Bounds bounds() {
    return new Prism(x, y, low, high).bounds();
  }

  @Override
  public double distanceM(Ray ray) {
    double[] span = {0.0, NEVER};
    if (!Bounds.cut(span, ray.z(), ray.dz(), low, high)) {
      return NEVER;
    }
    if (holds(ray.x() + span[0] * ray.dx(), ray.y() + span[0] * ray.dy())) {
      return span[0];
    }
    double[] walls = new double[x.length];
    int count = 0;
    for (int i = 0; i < x.length; i++) {
      double along = wall(ray, i);
      if (along >= span[0] && along <= span[1]) {
        walls[count++] = along;
      }
    }
    return Arrays.stream(walls, 0, count).min().orElse(NEVER);
  }

  /** Distance along a ray to a wall, seen from above [m]; negative behind, NaN beside it. */
  private double wall(Ray ray, int i) {
    int j = (i + 1) % x.length;
    double wayX = x[j] - x[i];
    double wayY = y[j] - y[i];
    double cross = ray.dx() * wayY - ray.dy() * wayX;
    double toX = x[i] - ray.x();
    double toY = y[i] - ray.y();
    double share = (toX * ray.dy() - toY * ray.dx()) / cross;
    return cross != 0.0 && share >= 0.0 && share <= 1.0
        ? (toX * wayY - toY * wayX) / cross
        : Double.NaN;
  }

  private boolean holds(double px, double py) {
    boolean inside = false;
    for (int i = 0, j = x.length - 1; i < x.length; j = i++) {
      boolean crosses = y[i] > py != y[j] > py;
      if (crosses && px < (x[j] - x[i]) * (py - y[i]) / (y[j] - y[i]) + x[i]) {
        inside = !inside;
      }
    }
    return inside;
  }

  @Override
  public boolean touches(Prism footprint) {
    if (footprint.verticalM(low, high) > 0.0) {
      return false;
    }
    double middle = (Math.max(low, footprint.low()) + Math.min(high, footprint.high())) / 2.0;
    for (int i = 0; i < x.length; i++) {
      int j = (i + 1) % x.length;
      if (footprint.meets(x[i], y[i], middle, x[j], y[j], middle)) {
        return true;
      }
    }
    return holds(footprint.x()[0], footprint.y()[0]);
  }
}
