package org.u2sa.planning.seen;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.marine.Dock;
import org.u2sa.messages.marine.Hoop;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.Line;
import org.u2sa.messages.shape.MovingSphere;
import org.u2sa.messages.shape.PointCloud;
import org.u2sa.messages.shape.PolyLine;
import org.u2sa.messages.shape.Polygon;
import org.u2sa.messages.shape.Rectangle;
import org.u2sa.messages.shape.Sphere;

/**
 * Converts objects to shapes and traffic on the planning plane. Immutable.
 *
 * @param vehicle state of the vehicle, for objects in its own axes
 */
record ObjectReader(PlanningPlane plane, StateInformation vehicle) {
  /** Radius of a point object [m]. */
  private static final double POINT_RADIUS_M = 0.1;

  private static final int HOOP_SIDES = 16;
  private static final double SKY = Double.POSITIVE_INFINITY;

  /** Converts an object to a frame of the plane. */
  private ObjectDescription placed(ObjectDescription object) {
    return plane.frameFor(object.referenceFrame()).equals(object.referenceFrame())
        ? object
        : object.in(plane.frame(), vehicle);
  }

  /**
   * Object as traffic, even if stationary; empty if neither its velocity nor its trajectory is
   * known. A trajectory without velocity is extrapolated from its last step.
   */
  Optional<Mover> mover(ObjectDescription raw, long micros) {
    ObjectDescription object = placed(raw);
    Optional<Point> velocity = object.motion().velocity();
    Point here = plane.ned(object.referenceFrame(), object.center());
    List<Point> points = new ArrayList<>(List.of(here));
    double stepS = 0.0;
    if (object instanceof MovingSphere sphere) {
      stepS = sphere.timeStep();
      for (Point point : sphere.trajectory()) {
        points.add(plane.ned(object.referenceFrame(), point));
      }
    }
    boolean hasWay = stepS > 0.0 && points.size() > 1;
    if (velocity.isEmpty() && !hasWay) {
      return Optional.empty();
    }
    Point there = plane.ned(object.referenceFrame(), object.after(1.0).center());
    double northMps = there.x() - here.x();
    double eastMps = there.y() - here.y();
    double downMps = there.z() - here.z();
    if (velocity.isEmpty()) {
      Point last = points.get(points.size() - 1).minus(points.get(points.size() - 2));
      northMps = last.x() / stepS;
      eastMps = last.y() / stepS;
      downMps = last.z() / stepS;
    }
    PlanarShape shape = shape(object, here);
    return Optional.of(
        new Mover(
            object.uid(),
            object.timestamp().orElse(micros),
            stepS,
            points.stream().mapToDouble(Point::x).toArray(),
            points.stream().mapToDouble(Point::y).toArray(),
            northMps,
            eastMps,
            outerRadiusM(shape, here),
            object.motion().sigma().map(sigma -> Math.max(sigma.x(), sigma.y())).orElse(0.0),
            object.motion().velocitySigma().orElse(0.0),
            new Mover.Heights(
                points.stream().mapToDouble(Point::z).toArray(),
                downMps,
                object instanceof Sphere ball ? ball.radius() : SKY)));
  }

  private static double outerRadiusM(PlanarShape shape, Point centre) {
    double farthest = 0.0;
    for (int i = 0; i < shape.count(); i++) {
      farthest =
          Math.max(farthest, Math.hypot(shape.northM(i) - centre.x(), shape.eastM(i) - centre.y()));
    }
    return farthest + shape.radiusM();
  }

  /** Centre of an object on the plane: north, east, down [m]. */
  Point centre(ObjectDescription raw) {
    ObjectDescription object = placed(raw);
    return plane.ned(object.referenceFrame(), object.center());
  }

  PlanarShape shape(ObjectDescription raw) {
    ObjectDescription object = placed(raw);
    return shape(object, plane.ned(object.referenceFrame(), object.center()));
  }

  private PlanarShape shape(ObjectDescription object, Point centre) {
    List<Point> middle = List.of(object.center());
    if (object instanceof Sphere sphere) {
      return points(object, middle, sphere.radius(), 2.0 * sphere.radius(), centre).asBall();
    } else if (object instanceof Cylinder cylinder) {
      return points(object, middle, cylinder.radius(), cylinder.height(), centre);
    } else if (object instanceof Circle circle) {
      return points(object, middle, circle.radius(), 0.0, centre);
    } else if (object instanceof Box box) {
      return turned(object, box.length(), box.width(), box.psi(), box.height(), centre);
    } else if (object instanceof Rectangle flat) {
      return turned(object, flat.length(), flat.width(), flat.psi(), 0.0, centre);
    } else if (object instanceof Hoop hoop) {
      return hoop(hoop, centre);
    } else if (object instanceof Dock dock) {
      return dock(dock, centre);
    } else if (object instanceof Polygon polygon) {
      return joined(object, PlanarShape.Kind.AREA, polygon.points(), 0.0, polygon.height(), centre);
    } else if (object instanceof PolyLine band) {
      return joined(
          object, PlanarShape.Kind.CHAIN, band.points(), 0.5 * band.width(), band.height(), centre);
    } else if (object instanceof Line line) {
      return joined(object, PlanarShape.Kind.CHAIN, line.points(), 0.0, 0.0, centre);
    } else if (object instanceof PointCloud cloud) {
      return points(object, cloud.points(), 0.0, 0.0, centre);
    }
    return points(object, middle, POINT_RADIUS_M, 0.0, centre);
  }

  /** An upright hoop is passable between its two sides. */
  private PlanarShape hoop(Hoop hoop, Point centre) {
    double radius = 0.5 * hoop.thickness();
    List<Point> ring = hoop.outline(HOOP_SIDES);
    return hoop.lying()
        ? joined(hoop, PlanarShape.Kind.CHAIN, ring, radius, hoop.thickness(), centre)
        : points(
            hoop,
            List.of(ring.get(0), ring.get(HOOP_SIDES / 2)),
            radius,
            2.0 * hoop.radius() + hoop.thickness(),
            centre);
  }

  /** The walls of a dock; if only its width was seen, everything that may be wall. */
  private PlanarShape dock(Dock dock, Point centre) {
    double radius = 0.5 * dock.thickness();
    return dock.length() == 0.0
        ? points(dock, List.of(dock.center()), 0.5 * dock.width(), dock.height(), centre)
        : joined(dock, PlanarShape.Kind.CHAIN, dock.outline(), radius, dock.height(), centre);
  }

  private PlanarShape points(
      ObjectDescription object, List<Point> points, double radius, double height, Point centre) {
    return joined(object, PlanarShape.Kind.POINTS, points, radius, height, centre);
  }

  /** Creates a rectangle whose length axis is rotated by psi in its frame's own sense. */
  private PlanarShape turned(
      ObjectDescription object,
      double length,
      double width,
      double psi,
      double height,
      Point centre) {
    boolean northFirst =
        object.referenceFrame().equals(ReferenceFrame.LOCAL_NED)
            || object.referenceFrame().isEarth();
    double heading = northFirst ? psi : Math.PI / 2.0 - psi;
    double[] norths = new double[4];
    double[] easts = new double[4];
    for (int corner = 0; corner < 4; corner++) {
      double along = corner < 2 ? 0.5 * length : -0.5 * length;
      double across = corner == 0 || corner == 3 ? 0.5 * width : -0.5 * width;
      norths[corner] = centre.x() + along * Math.cos(heading) - across * Math.sin(heading);
      easts[corner] = centre.y() + along * Math.sin(heading) + across * Math.cos(heading);
    }
    return made(object, PlanarShape.Kind.AREA, norths, easts, 0.0, height, centre);
  }

  private PlanarShape joined(
      ObjectDescription object,
      PlanarShape.Kind kind,
      List<Point> points,
      double radius,
      double height,
      Point centre) {
    List<Point> known = points.isEmpty() ? List.of(object.center()) : points;
    double[] norths = new double[known.size()];
    double[] easts = new double[known.size()];
    for (int i = 0; i < norths.length; i++) {
      Point ned = plane.ned(object.referenceFrame(), known.get(i));
      norths[i] = ned.x();
      easts[i] = ned.y();
    }
    return made(object, kind, norths, easts, radius, height, centre);
  }

  /** Objects without height, such as circles and points, are vertically unbounded. */
  private static PlanarShape made(
      ObjectDescription object,
      PlanarShape.Kind kind,
      double[] norths,
      double[] easts,
      double radius,
      double height,
      Point centre) {
    return new PlanarShape(
        object.uid(),
        kind,
        norths,
        easts,
        radius,
        height > 0.0 ? centre.z() - 0.5 * height : -SKY,
        height > 0.0 ? centre.z() + 0.5 * height : SKY);
  }
}
