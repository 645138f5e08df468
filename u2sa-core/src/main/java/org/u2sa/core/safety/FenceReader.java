package org.u2sa.core.safety;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.operation.valid.IsValidOp;
import org.locationtech.jts.operation.valid.TopologyValidationError;
import org.u2sa.interfaces.units.XmlNumbers;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.messages.cbor.Limits;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.Waypoint;

/** Reads {@code <fence>} (docs/health-and-failsafes.md) and rejects areas that enclose nothing. */
final class FenceReader {
  private static final String RALLY = "rally";
  private static final int MAX_RALLY_POINTS = 100;
  private static final int MIN_CORNERS = 3;
  private static final int CIRCLE_CORNERS = 64;
  private static final double INSIDE = 1.0; // corners are on the circle
  private static final double AROUND = 1.0 / Math.cos(Math.PI / CIRCLE_CORNERS); // edges touch it

  private final GeometryFactory geometry = new GeometryFactory();
  private final boolean onEarth;
  private Geodetic origin; // first corner read; null until then, and on a local plane

  private FenceReader(boolean onEarth) {
    this.onEarth = onEarth;
  }

  /** Reads a fence; errors name file, line, element, value and what was expected. */
  static Fence read(Path file) {
    return read(XmlReader.read(file, "fence"));
  }

  /** {@link #read(Path)} of an element {@code <fence>}. */
  static Fence read(XmlElement root) {
    root.refuseUnknownAttributes();
    root.refuseUnknownChildren("reference", "floor", "ceiling", "keepIn", "keepOut", RALLY);
    return new FenceReader(isOnEarth(root)).fence(root);
  }

  private static boolean isOnEarth(XmlElement root) {
    Optional<XmlElement> reference = root.child("reference");
    String frame = reference.map(XmlElement::text).orElse("Global");
    if (!frame.equalsIgnoreCase("Global") && !frame.equalsIgnoreCase("Local ENU")) {
      throw reference.get().error("\"" + frame + "\" is not one of Global, Local ENU");
    }
    return frame.equalsIgnoreCase("Global");
  }

  private Fence fence(XmlElement root) {
    Optional<XmlElement> keepIn = root.child("keepIn");
    List<XmlElement> keepOuts = root.children("keepOut");
    List<XmlElement> rally = root.children(RALLY);
    if (keepIn.isEmpty() && keepOuts.isEmpty() && rally.isEmpty()) {
      throw root.error("lacks <keepIn>; expected one, or a <keepOut> or <rally>");
    }
    if (rally.size() > MAX_RALLY_POINTS) {
      throw root.error("has " + rally.size() + " <rally>; expected at most " + MAX_RALLY_POINTS);
    }
    Optional<Polygon> inside = keepIn.map(area -> area(area, INSIDE));
    List<Polygon> outside = new ArrayList<>();
    keepOuts.forEach(area -> outside.add(area(area, AROUND)));
    List<Fence.RallyPoint> points = new ArrayList<>();
    rally.forEach(each -> points.add(rallyPoint(each, points.size() + 1)));
    OptionalDouble floor = altitude(root, "floor");
    OptionalDouble ceiling = altitude(root, "ceiling");
    if (floor.isPresent() && ceiling.isPresent() && floor.getAsDouble() >= ceiling.getAsDouble()) {
      throw root.child("ceiling")
          .orElseThrow()
          .error(
              ceiling.getAsDouble() + " m is not above the floor of " + floor.getAsDouble() + " m");
    }
    return new Fence(Optional.ofNullable(origin), inside, outside, floor, ceiling, points);
  }

  private Fence.RallyPoint rallyPoint(XmlElement element, int number) {
    element.refuseUnknownAttributes();
    element.refuseUnknownChildren("x", "y", "z");
    Coordinate place = coordinate(element);
    String name = RALLY + " " + number;
    Waypoint waypoint =
        new Waypoint()
            .uid(name)
            .referenceFrame(onEarth ? ReferenceFrame.GLOBAL : ReferenceFrame.LOCAL_ENU)
            .x(number(element, "x"))
            .y(number(element, "y"))
            .horizontalThreshold(1.0);
    altitude(element, "z").ifPresent(waypoint::z);
    waypoint.freeze();
    return new Fence.RallyPoint(name, waypoint, Point.of(place.x, place.y, 0.0));
  }

  private static OptionalDouble altitude(XmlElement root, String name) {
    Optional<XmlElement> element = root.child(name);
    element.ifPresent(each -> each.refuseUnknownAttributes("unit"));
    return element.isPresent()
        ? OptionalDouble.of(bounded(element.get(), "m"))
        : OptionalDouble.empty();
  }

  /**
   * @param scale ratio of a circle's radius to that of its corners
   */
  private Polygon area(XmlElement area, double scale) {
    return area.child("centre").isPresent() ? circle(area, scale) : polygon(area);
  }

  private Polygon polygon(XmlElement area) {
    area.refuseUnknownAttributes();
    area.refuseUnknownChildren("corner");
    List<Coordinate> corners = new ArrayList<>();
    for (XmlElement corner : area.children("corner")) {
      corners.add(place(corner));
    }
    if (corners.size() < MIN_CORNERS) {
      throw area.error("has " + corners.size() + " <corner>; expected 3 or more");
    }
    corners.add(corners.get(0).copy());
    Polygon polygon = geometry.createPolygon(corners.toArray(new Coordinate[0]));
    TopologyValidationError wrong = new IsValidOp(polygon).getValidationError();
    if (wrong != null) {
      throw area.error(
          "encloses no area in one piece ("
              + wrong.getMessage()
              + "); expected the corners in order, once around");
    }
    return polygon;
  }

  private Polygon circle(XmlElement area, double scale) {
    area.refuseUnknownAttributes();
    area.refuseUnknownChildren("centre", "radius");
    Coordinate centre = place(area.child("centre").orElseThrow());
    XmlElement radius =
        area.child("radius").orElseThrow(() -> area.error("has a <centre> but no <radius>"));
    radius.refuseUnknownAttributes("unit");
    double radiusM = bounded(radius, "m");
    if (!(radiusM > 0.0)) {
      throw radius.error(radiusM + " m: expected more than 0 m");
    }
    return (Polygon) geometry.createPoint(centre).buffer(radiusM * scale, CIRCLE_CORNERS / 4);
  }

  private Coordinate place(XmlElement element) {
    element.refuseUnknownAttributes();
    element.refuseUnknownChildren("x", "y");
    return coordinate(element);
  }

  private Coordinate coordinate(XmlElement element) {
    double x = number(element, "x");
    double y = number(element, "y");
    if (!onEarth) {
      return new Coordinate(x, y);
    }
    XmlNumbers.checkLongitude(element.child("x").orElseThrow(), x);
    XmlNumbers.checkLatitude(element.child("y").orElseThrow(), y);
    if (origin == null) {
      origin = new Geodetic(x, y, 0.0);
    }
    Point plane = Fence.plane(origin, x, y);
    return new Coordinate(plane.x(), plane.y());
  }

  private double number(XmlElement element, String name) {
    XmlElement number = element.requiredChild(name);
    number.refuseUnknownAttributes("unit");
    String unit = onEarth ? "deg" : "m";
    return bounded(number, unit);
  }

  /** A number with which calculations stay finite. */
  private static double bounded(XmlElement element, String unit) {
    double value = XmlNumbers.converted(element, unit, unit);
    if (Math.abs(value) > Limits.COORDINATE) {
      throw element.error(value + " " + unit + ": expected at most " + Limits.COORDINATE);
    }
    return value;
  }
}
