package org.u2sa.scenarios.igvc;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.Line;
import org.u2sa.messages.shape.PolyLine;
import org.u2sa.sim.camera.Scenery;

/**
 * Places the objects of a course, given in the axes of its layout, optionally rotated and mirrored.
 */
final class CourseBuilder {
  static final double BARREL_RADIUS_M = 0.3;
  static final double POTHOLE_RADIUS_M = 0.3048; // 2 ft across
  private static final double BARREL_HEIGHT_M = 1.0;
  private static final double SAWHORSE_WIDTH_M = 0.5;
  private static final double FLAG_RADIUS_M = 0.03;

  private final List<ObjectDescription> objects = new ArrayList<>();
  private final Point origin; // course origin, in layout axes
  private final double cos;
  private final double sin;
  private final double mirror;

  /**
   * @param origin point of the layout that becomes the course origin
   * @param turnedRad rotation of the layout, counterclockwise [rad]
   * @param mirrored whether left and right are swapped
   */
  CourseBuilder(Point origin, double turnedRad, boolean mirrored) {
    this.origin = origin;
    cos = StrictMath.cos(turnedRad);
    sin = StrictMath.sin(turnedRad);
    mirror = mirrored ? -1.0 : 1.0;
  }

  private Point placed(Point layout) {
    double x = layout.x() - origin.x();
    double y = mirror * (layout.y() - origin.y());
    return Point.of(x * cos - y * sin, x * sin + y * cos, 0.0);
  }

  private double turned(double headingRad) {
    return mirror * headingRad + StrictMath.atan2(sin, cos);
  }

  private <O extends ObjectDescription> O named(O object, String type, Point at, double upM) {
    long number = objects.stream().filter(o -> o.objectType().equals(type)).count() + 1;
    object.uid(type + " " + number).objectType(type);
    object.referenceFrame(ReferenceFrame.LOCAL_ENU).x(at.x()).y(at.y()).z(upM);
    objects.add(object);
    return object;
  }

  void line(String type, List<Point> layout) {
    List<Point> points = layout.stream().map(this::placed).toList();
    PolyLine line = named(new PolyLine(), type, points.get(0), 0.0);
    line.points(points).width(Course.LINE_M);
  }

  void start(Point from, Point to) {
    Line line = named(new Line(), Course.START, placed(from), 0.0);
    line.points(List.of(placed(from), placed(to)));
  }

  void waypoint(Point at) {
    named(new Circle(), Course.WAYPOINT, placed(at), 0.0).radius(Course.WAYPOINT_M);
  }

  void barrel(Point at) {
    Cylinder barrel = named(new Cylinder(), Scenery.BARREL, placed(at), 0.5 * BARREL_HEIGHT_M);
    barrel.height(BARREL_HEIGHT_M).radius(BARREL_RADIUS_M);
  }

  void flag(Point at, boolean red) {
    boolean isRed = red == mirror > 0.0; // mirroring swaps the sides
    String type = isRed ? Scenery.RED_FLAG : Scenery.BLUE_FLAG;
    named(new Cylinder(), type, placed(at), 0.5).height(1.0).radius(FLAG_RADIUS_M);
  }

  void pothole(Point at) {
    named(new Circle(), Scenery.POTHOLE, placed(at), 0.0).radius(POTHOLE_RADIUS_M);
  }

  /**
   * Adds a sawhorse.
   *
   * @param alongRad direction of its length in the layout [rad]
   */
  void sawhorse(Point at, double alongRad, double lengthM) {
    Box box = named(new Box(), Scenery.SAWHORSE, placed(at), 0.5);
    box.length(lengthM).width(SAWHORSE_WIDTH_M).height(1.0).psi(turned(alongRad));
  }

  /**
   * Creates a ramp without adding it.
   *
   * @param profile centre line in the layout, with heights
   */
  PolyLine ramp(List<Point> profile, double widthM) {
    List<Point> points = new ArrayList<>();
    for (Point point : profile) {
      Point at = placed(point);
      points.add(Point.of(at.x(), at.y(), point.z()));
    }
    PolyLine ramp = new PolyLine();
    ramp.points(points).width(widthM).uid(Scenery.RAMP + " 1").objectType(Scenery.RAMP);
    ramp.referenceFrame(ReferenceFrame.LOCAL_ENU);
    ramp.x(points.get(0).x()).y(points.get(0).y()).z(0.0);
    ramp.freeze();
    return ramp;
  }

  Course course(String name) {
    objects.forEach(ObjectDescription::freeze);
    return new Course(name, objects);
  }
}
