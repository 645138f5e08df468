package org.u2sa.gcs.ros;

import static org.u2sa.gcs.ros.RosSpelling.fields;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.messages.marine.Dock;
import org.u2sa.messages.marine.Hoop;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.Line;
import org.u2sa.messages.shape.Polygon;
import org.u2sa.messages.shape.Rectangle;
import org.u2sa.messages.shape.Sphere;
import org.u2sa.recorder.foxglove.SceneFrame;

/** The vehicle's objects as {@code visualization_msgs/MarkerArray}. */
final class RosMarkers {
  private static final int CUBE = 1;
  private static final int SPHERE = 2;
  private static final int CYLINDER = 3;
  private static final int LINE_STRIP = 4;
  private static final int ADD = 0;
  private static final int DELETE_ALL = 3;
  private static final int HOOP_SIDES = 24;
  private static final double FLAT_M = 0.05; // height drawn if unknown
  private static final double POINT_M = 0.5; // size drawn if unknown
  private static final double LINE_M = 0.1;
  private static final Map<String, Object> COLOUR = fields("r", 1.0, "g", 0.5, "b", 0.1, "a", 0.8);

  private final RosFrames frames;

  RosMarkers(RosFrames frames) {
    this.frames = frames;
  }

  /** All objects, replacing those drawn before. */
  Optional<Object> of(ObjectList list) {
    RosSpelling.Time stamp = RosStates.stamp(list);
    List<Object> markers = new ArrayList<>();
    RosSpelling.Header nowhere = new RosSpelling.Header(stamp, RosFrames.MAP);
    markers.add(
        marker(
            nowhere,
            "",
            0,
            new Look(SPHERE, DELETE_ALL, cube(POINT_M), 0.0),
            Point.ORIGIN,
            List.of()));
    for (ObjectDescription object : list.objects()) {
      frames
          .place(object.referenceFrame(), object.center())
          .ifPresent(at -> markers.add(marker(object, at, stamp, markers.size())));
    }
    return Optional.of(fields("markers", markers));
  }

  private record Look(int type, int action, Point size, double turn) {}

  private Map<String, Object> marker(
      ObjectDescription object, SceneFrame.Placed at, RosSpelling.Time stamp, int id) {
    List<Object> outline = new ArrayList<>();
    for (Point point : outline(object)) {
      frames
          .place(object.referenceFrame(), point)
          .ifPresent(each -> outline.add(RosFrames.xyz(each.point())));
    }
    String kind = object.objectType().isEmpty() ? "object" : object.objectType();
    return marker(
        new RosSpelling.Header(stamp, at.frame()),
        kind,
        id,
        look(object),
        outline.isEmpty() ? at.point() : Point.ORIGIN,
        outline);
  }

  private static Look look(ObjectDescription object) {
    if (object instanceof Sphere sphere) {
      return new Look(SPHERE, ADD, cube(2 * sphere.radius()), 0.0);
    }
    if (object instanceof Cylinder cylinder) {
      return new Look(CYLINDER, ADD, round(cylinder.radius(), cylinder.height()), 0.0);
    }
    if (object instanceof Circle circle) {
      return new Look(CYLINDER, ADD, round(circle.radius(), FLAT_M), 0.0);
    }
    if (object instanceof Box box) {
      Point size = Point.of(box.length(), box.width(), Math.max(box.height(), FLAT_M));
      return new Look(CUBE, ADD, size, SceneFrame.turn(object.referenceFrame(), box.psi()));
    }
    if (object instanceof Rectangle rectangle) {
      Point size = Point.of(rectangle.length(), rectangle.width(), FLAT_M);
      return new Look(CUBE, ADD, size, SceneFrame.turn(object.referenceFrame(), rectangle.psi()));
    }
    boolean isDrawn = !outline(object).isEmpty();
    return new Look(isDrawn ? LINE_STRIP : SPHERE, ADD, cube(isDrawn ? LINE_M : POINT_M), 0.0);
  }

  private static List<Point> outline(ObjectDescription object) {
    if (object instanceof Hoop hoop) {
      return hoop.outline(HOOP_SIDES);
    }
    if (object instanceof Dock dock) {
      return dock.outline();
    }
    if (object instanceof Line line) {
      return line.points();
    }
    if (object instanceof Polygon polygon && !polygon.points().isEmpty()) {
      List<Point> closed = new ArrayList<>(polygon.points());
      closed.add(closed.get(0));
      return closed;
    }
    return List.of();
  }

  private static Point cube(double side) {
    return Point.of(side, side, side);
  }

  private static Point round(double radius, double height) {
    return Point.of(2 * radius, 2 * radius, Math.max(height, FLAT_M));
  }

  private static Map<String, Object> marker(
      RosSpelling.Header header, String kind, int id, Look look, Point at, List<Object> points) {
    return fields(
        "header",
        header,
        "ns",
        kind,
        "id",
        id,
        "type",
        look.type(),
        "action",
        look.action(),
        "pose",
        fields(
            "position",
            RosFrames.xyz(at),
            "orientation",
            RosFrames.quaternion(Rotation.aboutUp(look.turn()))),
        "scale",
        RosFrames.xyz(look.size()),
        "color",
        COLOUR,
        "lifetime",
        new RosSpelling.Time(0),
        "frame_locked",
        false,
        "points",
        points,
        "colors",
        List.of(),
        "text",
        "",
        "mesh_resource",
        "",
        "mesh_use_embedded_materials",
        false);
  }
}
