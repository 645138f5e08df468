package org.u2sa.world.sdf;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.Polygon;
import org.u2sa.messages.shape.Sphere;

/**
 * Objects for {@code <geometry>}. Tilted shapes and meshes are replaced by their upright bounding
 * prism.
 */
final class SdfGeometry {
  private static final int ROUND = 24; // corners of a rim
  private static final double FLAT_M = 1e-3; // thickness of flat shapes

  private final SdfMesh meshes;
  private final SdfOmissions omissions;

  /**
   * @param omissions receives elements that cannot be objects, with the reason
   */
  SdfGeometry(SdfMesh meshes, SdfOmissions omissions) {
    this.meshes = meshes;
    this.omissions = omissions;
  }

  /**
   * The object of a geometry.
   *
   * @param pose of the geometry in the world
   * @param name name in reports of ignored elements
   */
  Optional<ObjectDescription> object(XmlElement geometry, SdfPose pose, String name) {
    for (XmlElement shape : geometry.children()) {
      switch (shape.name()) {
        case "box":
          return Optional.of(box(shape, pose));
        case "cylinder":
          return Optional.of(
              cylinder(
                  SdfNumbers.positive(shape, "radius"),
                  SdfNumbers.positive(shape, "length"),
                  pose));
        case "capsule":
          double radius = SdfNumbers.positive(shape, "radius");
          double length = SdfNumbers.positive(shape, "length");
          return Optional.of(cylinder(radius, length + 2.0 * radius, pose));
        case "sphere":
          return Optional.of(sphere(SdfNumbers.positive(shape, "radius"), pose));
        case "polyline":
          return polylines(geometry, pose, name);
        case "mesh":
          return mesh(shape, pose, name);
        case "plane":
          omissions.harmless(name + ": a plane; the ground is the simulation's");
          return Optional.empty();
        case "heightmap":
          omissions.obstacle(name + ": a heightmap; give it as <environment> of a world file");
          return Optional.empty();
        case "empty":
          omissions.harmless(name + ": <empty> in line " + shape.line());
          return Optional.empty();
        default:
          omissions.obstacle(name + ": <" + shape.name() + "> in line " + shape.line());
      }
    }
    return Optional.empty();
  }

  private static ObjectDescription box(XmlElement shape, SdfPose pose) {
    double[] size = SdfNumbers.of(shape.requiredChild("size"), 3);
    for (double each : size) {
      if (!(each > 0.0)) {
        throw shape.error("<size> " + each + ": expected numbers above 0");
      }
    }
    if (pose.isUpright()) {
      Box box = new Box().length(size[0]).width(size[1]).height(size[2]);
      box.psi(pose.yawRad());
      return at(box, pose.at());
    }
    List<Point> corners = new ArrayList<>();
    for (int i = 0; i < 8; i++) {
      double x = ((i & 1) - 0.5) * size[0];
      double y = ((i >> 1 & 1) - 0.5) * size[1];
      double z = ((i >> 2 & 1) - 0.5) * size[2];
      corners.add(pose.place(Point.of(x, y, z)));
    }
    return prism(corners);
  }

  private static ObjectDescription cylinder(double radius, double length, SdfPose pose) {
    if (pose.isUpright()) {
      return at(new Cylinder().radius(radius).height(length), pose.at());
    }
    List<Point> rims = new ArrayList<>();
    for (int i = 0; i < ROUND; i++) {
      double angle = 2.0 * Math.PI * i / ROUND;
      double x = radius * Math.cos(angle);
      double y = radius * Math.sin(angle);
      rims.add(pose.place(Point.of(x, y, length / 2.0)));
      rims.add(pose.place(Point.of(x, y, -length / 2.0)));
    }
    return prism(rims);
  }

  private static ObjectDescription sphere(double radius, SdfPose pose) {
    return at(new Sphere().radius(radius), pose.at());
  }

  private Optional<ObjectDescription> polylines(XmlElement geometry, SdfPose pose, String name) {
    List<Point> points = new ArrayList<>();
    for (XmlElement shape : geometry.children("polyline")) { // the others are usually holes
      double height = SdfNumbers.positive(shape, "height");
      for (XmlElement point : shape.children("point")) {
        double[] xy = SdfNumbers.of(point, 2);
        points.add(pose.place(Point.of(xy[0], xy[1], 0.0)));
        points.add(pose.place(Point.of(xy[0], xy[1], height)));
      }
    }
    return hull(points, name);
  }

  private Optional<ObjectDescription> mesh(XmlElement shape, SdfPose pose, String name) {
    List<Point> points = new ArrayList<>();
    try {
      meshes.points(shape).forEach(each -> points.add(pose.place(each)));
    } catch (IOException e) {
      omissions.obstacle(name + ": mesh " + shape.requiredChild("uri").text() + e.getMessage());
      return Optional.empty();
    }
    return hull(points, name);
  }

  private Optional<ObjectDescription> hull(List<Point> points, String name) {
    List<Point> outline = ConvexHull.of(points);
    if (outline.size() < 3) {
      omissions.obstacle(name + ": has no extent, seen from above");
      return Optional.empty();
    }
    return Optional.of(prism(points, outline));
  }

  private static ObjectDescription prism(List<Point> points) {
    return prism(points, ConvexHull.of(points));
  }

  private static ObjectDescription prism(List<Point> points, List<Point> hull) {
    double low = points.stream().mapToDouble(Point::z).min().orElse(0.0);
    double high = points.stream().mapToDouble(Point::z).max().orElse(0.0);
    List<Point> outline = new ArrayList<>();
    double x = 0.0;
    double y = 0.0;
    for (Point corner : hull) {
      outline.add(Point.of(corner.x(), corner.y(), 0.0));
      x += corner.x() / hull.size();
      y += corner.y() / hull.size();
    }
    Polygon polygon = new Polygon().points(outline).height(Math.max(FLAT_M, high - low));
    return at(polygon, Point.of(x, y, (low + high) / 2.0));
  }

  private static ObjectDescription at(ObjectDescription object, Point place) {
    object.x(place.x()).y(place.y()).z(place.z());
    return object;
  }

  /** The convex outline of points seen from above: Andrew's monotone chain. */
  static final class ConvexHull {
    private ConvexHull() {}

    /** Corners of the outline, anticlockwise; fewer than three if it has no area. */
    static List<Point> of(List<Point> points) {
      List<Point> sorted = new ArrayList<>(points);
      sorted.sort(Comparator.comparingDouble(Point::x).thenComparingDouble(Point::y));
      List<Point> hull = new ArrayList<>();
      for (Point point : sorted) {
        append(hull, point, 1);
      }
      int lower = hull.size();
      for (int i = sorted.size() - 2; i >= 0; i--) {
        append(hull, sorted.get(i), lower);
      }
      if (!hull.isEmpty()) {
        hull.remove(hull.size() - 1); // the first again
      }
      return hull;
    }

    private static void append(List<Point> hull, Point next, int kept) {
      while (hull.size() > kept && !turnsLeft(hull, next)) {
        hull.remove(hull.size() - 1);
      }
      hull.add(next);
    }

    private static boolean turnsLeft(List<Point> hull, Point c) {
      Point a = hull.get(hull.size() - 2);
      Point b = hull.get(hull.size() - 1);
      return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()) > 0.0;
    }
  }
}
