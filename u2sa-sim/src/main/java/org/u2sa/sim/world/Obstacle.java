package org.u2sa.sim.world;

import java.util.List;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.marine.Dock;
import org.u2sa.messages.marine.Hoop;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.Line;
import org.u2sa.messages.shape.PointCloud;
import org.u2sa.messages.shape.Polygon;
import org.u2sa.messages.shape.Rectangle;
import org.u2sa.messages.shape.Sphere;

/** Collision shape of an object in world axes, for rays and footprints. */
sealed interface Obstacle
    permits Obstacle.Block, Obstacle.Pillar, Obstacle.Ball, Obstacle.Wire, Tower, Ring, Several {
  double NEVER = Double.POSITIVE_INFINITY;

  Bounds bounds();

  /** Distance along a ray [m]; 0 inside, infinite for a miss. */
  double distanceM(Ray ray);

  boolean touches(Prism footprint);

  /**
   * Creates the shape of an object.
   *
   * @throws IllegalArgumentException if its frame is a vehicle frame or its shape is unsupported
   */
  static Obstacle of(ObjectDescription object, LocalPlane plane) {
    ReferenceFrame frame = object.referenceFrame();
    if (frame.isBody()) {
      throw new IllegalArgumentException(
          "obstacle \"" + object.uid() + "\" is in " + frame + ": expected a frame of the world");
    }
    boolean earth = frame.isEarth();
    ObjectDescription placed =
        object.in(earth ? ReferenceFrame.GLOBAL : ReferenceFrame.LOCAL_ENU, null);
    Point c = earth ? plane.point(Geodetic.of(placed.center())) : placed.center();
    if (placed instanceof Box box) {
      double psi = earth ? Math.PI / 2.0 - box.psi() : box.psi();
      return Block.of(c, psi, box.length(), box.width(), box.height());
    } else if (placed instanceof Rectangle flat) {
      double psi = earth ? Math.PI / 2.0 - flat.psi() : flat.psi();
      return Block.of(c, psi, flat.length(), flat.width(), 0.0);
    } else if (placed instanceof Cylinder cylinder) {
      return new Pillar(c.x(), c.y(), c.z(), cylinder.radius(), cylinder.height() / 2.0);
    } else if (placed instanceof Circle disc) {
      return new Pillar(c.x(), c.y(), c.z(), disc.radius(), 0.0);
    } else if (placed instanceof Sphere ball) {
      return new Ball(c.x(), c.y(), c.z(), ball.radius());
    } else if (placed instanceof Polygon area && area.points().size() > 2) {
      return Tower.of(inWorld(area.points(), c, earth, plane), c.z(), area.height());
    } else if (placed instanceof Hoop hoop) {
      double psi = earth ? Math.PI / 2.0 - hoop.psi() : hoop.psi();
      return Ring.of(c, psi, hoop);
    } else if (placed instanceof Dock dock) {
      return new Several(dock.walls().stream().map(wall -> Obstacle.of(wall, plane)).toList());
    } else if (placed instanceof Line line) {
      return new Wire(inWorld(line.points(), c, earth, plane), true);
    } else if (placed instanceof PointCloud cloud) {
      return new Wire(inWorld(cloud.points(), c, earth, plane), false);
    } else if (placed.getClass() == ObjectDescription.class) {
      return new Wire(List.of(c), false);
    }
    throw new IllegalArgumentException(
        "obstacle \""
            + object.uid()
            + "\" is a "
            + object.type().name()
            + ", which is not a supported shape");
  }

  private static List<Point> inWorld(
      List<Point> points, Point centre, boolean earth, LocalPlane plane) {
    if (points.isEmpty()) {
      return List.of(centre);
    }
    return earth ? points.stream().map(point -> plane.point(Geodetic.of(point))).toList() : points;
  }

  /** An upright box; without height, a level rectangle. */
  record Block(Point centre, double cos, double sin, double ahead, double aside, double up)
      implements Obstacle {
    static Block of(Point centre, double psi, double length, double width, double height) {
      double cos = StrictMath.cos(psi);
      double sin = StrictMath.sin(psi);
      return new Block(centre, cos, sin, length / 2.0, width / 2.0, height / 2.0);
    }

    private Prism prism() {
      double[] x = new double[4];
      double[] y = new double[4];
      for (int i = 0; i < 4; i++) {
        double a = i < 2 ? ahead : -ahead;
        double b = i == 1 || i == 2 ? aside : -aside;
        x[i] = centre.x() + a * cos - b * sin;
        y[i] = centre.y() + a * sin + b * cos;
      }
      return new Prism(x, y, centre.z() - up, centre.z() + up);
    }

    @Override
    public Bounds bounds() {
      return prism().bounds();
    }

    @Override
    public double distanceM(Ray ray) {
      double x = ray.x() - centre.x();
      double y = ray.y() - centre.y();
      double[] span = {0.0, NEVER};
      boolean met =
          Bounds.cut(span, x * cos + y * sin, ray.dx() * cos + ray.dy() * sin, -ahead, ahead)
              && Bounds.cut(span, y * cos - x * sin, ray.dy() * cos - ray.dx() * sin, -aside, aside)
              && Bounds.cut(span, ray.z() - centre.z(), ray.dz(), -up, up);
      return met ? span[0] : NEVER;
    }

    @Override
    public boolean touches(Prism footprint) {
      return footprint.verticalM(centre.z() - up, centre.z() + up) == 0.0
          && footprint.overlaps(prism());
    }
  }

  /** An upright cylinder; without height, a level disc. */
  record Pillar(double x, double y, double z, double radius, double up) implements Obstacle {
    @Override
    public Bounds bounds() {
      return Bounds.around(x, y, z, radius, up);
    }

    @Override
    public double distanceM(Ray ray) {
      double[] span = {0.0, NEVER};
      boolean met =
          cutRound(span, ray.x() - x, ray.y() - y, 0.0, ray.dx(), ray.dy(), 0.0, radius)
              && Bounds.cut(span, ray.z() - z, ray.dz(), -up, up);
      return met ? span[0] : NEVER;
    }

    @Override
    public boolean touches(Prism footprint) {
      return footprint.verticalM(z - up, z + up) == 0.0 && footprint.distanceM(x, y) <= radius;
    }
  }

  /** A sphere. */
  record Ball(double x, double y, double z, double radius) implements Obstacle {
    @Override
    public Bounds bounds() {
      return Bounds.around(x, y, z, radius, radius);
    }

    @Override
    public double distanceM(Ray ray) {
      double[] span = {0.0, NEVER};
      boolean met =
          cutRound(
              span, ray.x() - x, ray.y() - y, ray.z() - z, ray.dx(), ray.dy(), ray.dz(), radius);
      return met ? span[0] : NEVER;
    }

    @Override
    public boolean touches(Prism footprint) {
      return Math.hypot(footprint.distanceM(x, y), footprint.verticalM(z, z)) <= radius;
    }
  }

  /** Points or polylines: infinitely thin, so rays never hit them. */
  record Wire(List<Point> points, boolean joined) implements Obstacle {
    @Override
    public Bounds bounds() {
      Bounds all = Bounds.NONE;
      for (Point point : points) {
        all = all.and(Bounds.around(point.x(), point.y(), point.z(), 0.0, 0.0));
      }
      return all;
    }

    @Override
    public double distanceM(Ray ray) {
      return NEVER;
    }

    @Override
    public boolean touches(Prism footprint) {
      for (int i = 0; i < points.size(); i++) {
        Point a = points.get(joined && i > 0 ? i - 1 : i);
        Point b = points.get(i);
        if (footprint.meets(a.x(), a.y(), a.z(), b.x(), b.y(), b.z())) {
          return true;
        }
      }
      return false;
    }
  }

  /** Clips a span of a line to a disc around the origin; false if nothing remains. */
  private static boolean cutRound(
      double[] span, double x, double y, double z, double dx, double dy, double dz, double r) {
    double squared = dx * dx + dy * dy + dz * dz;
    if (squared == 0.0) {
      return x * x + y * y + z * z <= r * r;
    }
    // Starts from the line's closest point, which keeps precision for distant lines.
    double nearest = -(x * dx + y * dy + z * dz) / squared;
    double cx = x + nearest * dx;
    double cy = y + nearest * dy;
    double cz = z + nearest * dz;
    double left = r * r - cx * cx - cy * cy - cz * cz;
    if (left < 0.0) {
      return false;
    }
    double half = StrictMath.sqrt(left / squared);
    span[0] = Math.max(span[0], nearest - half);
    span[1] = Math.min(span[1], nearest + half);
    return span[0] <= span[1];
  }
}
