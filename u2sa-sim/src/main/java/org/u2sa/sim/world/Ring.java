package org.u2sa.sim.world;

import java.util.List;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.marine.Hoop;

/**
 * A hoop: rays hit it where they cross its plane within half its thickness of the circle;
 * footprints are tested against its centre line.
 *
 * @param normal unit vector
 * @param half half the thickness [m]
 * @param circle its centre line, closed
 */
record Ring(Point centre, Point normal, double radius, double half, Wire circle)
    implements Obstacle {
  private static final int SIDES = 24;

  /**
   * Creates a ring.
   *
   * @param psi direction of an upright hoop's normal from x (east) towards y (north) [rad]
   */
  static Ring of(Point centre, double psi, Hoop hoop) {
    Point across = Point.of(-StrictMath.sin(psi), StrictMath.cos(psi), 0.0);
    Point ahead = Point.of(StrictMath.cos(psi), StrictMath.sin(psi), 0.0);
    Point up = Point.of(0.0, 0.0, 1.0);
    Point other = hoop.lying() ? ahead : up;
    Point[] points = new Point[SIDES + 1];
    for (int i = 0; i <= SIDES; i++) {
      double angle = 2.0 * Math.PI * (i % SIDES) / SIDES;
      points[i] =
          centre
              .plus(across.times(hoop.radius() * StrictMath.cos(angle)))
              .plus(other.times(hoop.radius() * StrictMath.sin(angle)));
    }
    return new Ring(
        centre,
        hoop.lying() ? up : ahead,
        hoop.radius(),
        hoop.thickness() / 2.0,
        new Wire(List.of(points), true));
  }

  @Override
  public Bounds bounds() {
    return Bounds.around(centre.x(), centre.y(), centre.z(), radius + half, radius + half);
  }

  @Override
  public double distanceM(Ray ray) {
    double x = centre.x() - ray.x();
    double y = centre.y() - ray.y();
    double z = centre.z() - ray.z();
    double speed = normal.x() * ray.dx() + normal.y() * ray.dy() + normal.z() * ray.dz();
    double along = (normal.x() * x + normal.y() * y + normal.z() * z) / speed;
    if (speed == 0.0 || along < 0.0) {
      return NEVER;
    }
    double off =
        Point.of(along * ray.dx() - x, along * ray.dy() - y, along * ray.dz() - z).distance();
    return Math.abs(off - radius) <= half ? along : NEVER;
  }

  @Override
  public boolean touches(Prism footprint) {
    return circle.touches(footprint);
  }
}
