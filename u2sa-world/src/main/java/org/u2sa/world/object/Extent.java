package org.u2sa.world.object;

import java.util.List;
import org.u2sa.messages.Metric;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.marine.Dock;
import org.u2sa.messages.marine.Hoop;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.Line;
import org.u2sa.messages.shape.PointCloud;
import org.u2sa.messages.shape.PolyLine;
import org.u2sa.messages.shape.Polygon;
import org.u2sa.messages.shape.Rectangle;
import org.u2sa.messages.shape.Sphere;

/** Radii of objects about their centres. */
final class Extent {
  private Extent() {}

  /** Radius of the smallest vertical cylinder about the centre that contains the object [m]. */
  static double radius(ObjectDescription object) {
    if (object instanceof Circle circle) {
      return circle.radius();
    } else if (object instanceof Cylinder cylinder) {
      return cylinder.radius();
    } else if (object instanceof Sphere sphere) {
      return sphere.radius();
    } else if (object instanceof Rectangle rectangle) {
      return Math.hypot(rectangle.length(), rectangle.width()) / 2.0;
    } else if (object instanceof Box box) {
      return Math.hypot(box.length(), box.width()) / 2.0;
    } else if (object instanceof Hoop hoop) {
      return hoop.radius() + hoop.thickness() / 2.0;
    } else if (object instanceof Dock dock) {
      return Math.hypot(dock.length(), dock.width()) / 2.0;
    } else if (object instanceof PolyLine band) {
      return farthest(band) + band.width() / 2.0;
    }
    return farthest(object);
  }

  /** Whether all of the object is within a distance of its centre [m] in each axis. */
  static boolean isWithin(ObjectDescription object, double metres) {
    double z = object.center().z();
    return radius(object) < metres
        && points(object).stream().allMatch(point -> Math.abs(point.z() - z) < metres);
  }

  private static List<Point> points(ObjectDescription object) {
    if (object instanceof PolyLine band) {
      return band.points();
    } else if (object instanceof Line line) {
      return line.points();
    } else if (object instanceof Polygon polygon) {
      return polygon.points();
    } else if (object instanceof PointCloud cloud) {
      return cloud.points();
    }
    return List.of();
  }

  private static double farthest(ObjectDescription object) {
    List<Point> points = points(object);
    if (points.isEmpty()) {
      return 0.0;
    }
    Metric metric = Metric.around(object.referenceFrame(), object.center());
    double farthest = 0.0;
    for (Point point : points) {
      Point metres = metric.metres(point);
      farthest = Math.max(farthest, Math.hypot(metres.x(), metres.y()));
    }
    return farthest;
  }
}
