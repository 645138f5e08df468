package org.u2sa.recorder.foxglove;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.marine.Dock;
import org.u2sa.messages.marine.Hoop;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.Line;
import org.u2sa.messages.shape.Polygon;
import org.u2sa.messages.shape.Rectangle;
import org.u2sa.messages.shape.Sphere;

/** Objects and paths as entities of a {@code foxglove.SceneUpdate}. */
final class SceneShapes {
  private static final int HOOP_SIDES = 24;
  private static final int CUBES = 8;
  private static final int SPHERES = 9;
  private static final int CYLINDERS = 10;
  private static final int LINES = 11;
  private static final int LINE_LOOP = 1;
  private static final double FLAT_M = 0.05; // height drawn if unknown
  private static final double POINT_M = 0.5; // size drawn if unknown
  private static final double LINE_M = 0.1;

  private final SceneFrame frames;

  SceneShapes(SceneFrame frames) {
    this.frames = frames;
  }

  /** Entity of an object; empty if its position is unknown. */
  Optional<ProtobufMessage> object(ObjectDescription object, long nanos) {
    return frames
        .place(object.referenceFrame(), object.center())
        .map(
            at -> {
              ProtobufMessage entity = entity(nanos, at.frame(), object.uid());
              add(entity, object, at.point());
              return entity;
            });
  }

  /** Entity of a path; empty if the map has no origin yet or the path is empty. */
  Optional<ProtobufMessage> path(PlannedPath path, long nanos) {
    List<Point> points = new ArrayList<>();
    String frame = placed(path.referenceFrame(), path.points(), points);
    if (points.size() < 2) {
      return Optional.empty();
    }
    ProtobufMessage entity = entity(nanos, frame, "plan " + path.subsystem());
    return Optional.of(entity.message(LINES, line(points, 0, colour(0.1, 0.6, 1.0))));
  }

  private static ProtobufMessage entity(long nanos, String frame, String id) {
    return new ProtobufMessage().time(1, nanos).text(2, frame).text(3, id);
  }

  private void add(ProtobufMessage entity, ObjectDescription object, Point at) {
    ProtobufMessage colour = colour(1.0, 0.5, 0.1);
    if (object instanceof Sphere sphere) {
      entity.message(SPHERES, primitive(at, 0.0, cube(2 * sphere.radius()), colour));
    } else if (object instanceof Cylinder cylinder) {
      double across = 2 * cylinder.radius();
      entity.message(
          CYLINDERS, cylinder(at, Point.of(across, across, high(cylinder.height())), colour));
    } else if (object instanceof Circle circle) {
      double across = 2 * circle.radius();
      entity.message(CYLINDERS, cylinder(at, Point.of(across, across, FLAT_M), colour));
    } else if (object instanceof Box box) {
      Point size = Point.of(box.length(), box.width(), high(box.height()));
      entity.message(
          CUBES, primitive(at, SceneFrame.turn(object.referenceFrame(), box.psi()), size, colour));
    } else if (object instanceof Rectangle rectangle) {
      Point size = Point.of(rectangle.length(), rectangle.width(), FLAT_M);
      entity.message(
          CUBES,
          primitive(at, SceneFrame.turn(object.referenceFrame(), rectangle.psi()), size, colour));
    } else if (object instanceof Hoop hoop) {
      entity.message(LINES, outline(object, hoop.outline(HOOP_SIDES), 0, colour));
    } else if (object instanceof Dock dock) {
      entity.message(LINES, outline(object, dock.outline(), 0, colour));
    } else if (object instanceof Polygon polygon) {
      entity.message(LINES, outline(object, polygon.points(), LINE_LOOP, colour));
    } else if (object instanceof Line line) {
      entity.message(LINES, outline(object, line.points(), 0, colour));
    } else {
      entity.message(SPHERES, primitive(at, 0.0, cube(POINT_M), colour));
    }
  }

  private ProtobufMessage outline(
      ObjectDescription object, List<Point> corners, int type, ProtobufMessage colour) {
    List<Point> points = new ArrayList<>();
    placed(object.referenceFrame(), corners, points);
    return line(points, type, colour);
  }

  private String placed(ReferenceFrame frame, List<Point> from, List<Point> to) {
    String name = SceneFrame.MAP;
    for (Point point : from) {
      Optional<SceneFrame.Placed> placed = frames.place(frame, point);
      if (placed.isPresent()) {
        name = placed.get().frame();
        to.add(placed.get().point());
      }
    }
    return name;
  }

  private static ProtobufMessage line(List<Point> points, int type, ProtobufMessage colour) {
    ProtobufMessage line =
        new ProtobufMessage()
            .whole(1, type)
            .message(2, SceneFrame.pose(Point.ORIGIN, SceneFrame.aboutUp(0.0)))
            .number(3, LINE_M);
    points.forEach(point -> line.message(5, SceneFrame.vector(point)));
    return line.message(6, colour);
  }

  private static ProtobufMessage primitive(
      Point at, double turn, Point size, ProtobufMessage colour) {
    return new ProtobufMessage()
        .message(1, SceneFrame.pose(at, SceneFrame.aboutUp(turn)))
        .message(2, SceneFrame.vector(size))
        .message(3, colour);
  }

  private static ProtobufMessage cylinder(Point at, Point size, ProtobufMessage colour) {
    return new ProtobufMessage()
        .message(1, SceneFrame.pose(at, SceneFrame.aboutUp(0.0)))
        .message(2, SceneFrame.vector(size))
        .number(3, 1.0)
        .number(4, 1.0)
        .message(5, colour);
  }

  private static Point cube(double side) {
    return Point.of(side, side, side);
  }

  private static double high(double height) {
    return Math.max(height, FLAT_M);
  }

  private static ProtobufMessage colour(double red, double green, double blue) {
    return new ProtobufMessage().number(1, red).number(2, green).number(3, blue).number(4, 0.8);
  }
}
