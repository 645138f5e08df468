package org.u2sa.core.safety;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.geom.prep.PreparedGeometry;
import org.locationtech.jts.geom.prep.PreparedGeometryFactory;
import org.locationtech.jts.simplify.TopologyPreservingSimplifier;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.shape.NearSides;

/**
 * Geofence: a keep-in polygon, keep-out polygons, two altitude limits and rally points, each
 * optional. Uses a local plane in metres east and north of the polygon's first corner, accurate
 * enough for fences of some tens of kilometres. Immutable.
 */
public final class Fence {
  private static final int CURVATURE_STEPS = 6;
  private static final int MAX_NEAR_SIDES = 10_000; // pairs

  /**
   * A position to return to instead of home if it is nearer.
   *
   * @param name "rally 1" is the fence's first
   * @param waypoint position; its threshold is ignored
   * @param place position in the fence's plane: x east, y north [m]
   */
  record RallyPoint(String name, Waypoint waypoint, Point place) {
    OptionalDouble altitudeM() {
      return waypoint.z();
    }

    boolean isAt(RallyPoint other) {
      return waypoint.x().equals(other.waypoint.x())
          && waypoint.y().equals(other.waypoint.y())
          && waypoint.z().equals(other.waypoint.z());
    }

    @Override
    public String toString() {
      return String.format(
          "%s at x %s, y %s", name, waypoint.x().orElseThrow(), waypoint.y().orElseThrow());
    }
  }

  private final Optional<Geodetic> origin; // empty on a local plane
  private final Optional<Polygon> keepIn;
  private final List<Polygon> keepOuts;
  final OptionalDouble floorM;
  final OptionalDouble ceilingM;
  private final List<RallyPoint> rally;
  private final Optional<Geometry> border; // of the keep-in area
  private final Optional<PreparedGeometry> inside;
  private final List<PreparedGeometry> outside;

  Fence(
      Optional<Geodetic> origin,
      Optional<Polygon> keepIn,
      List<Polygon> keepOuts,
      OptionalDouble floorM,
      OptionalDouble ceilingM,
      List<RallyPoint> rally) {
    this.origin = origin;
    this.keepIn = keepIn;
    this.keepOuts = List.copyOf(keepOuts);
    this.floorM = floorM;
    this.ceilingM = ceilingM;
    this.rally = List.copyOf(rally);
    border = keepIn.map(Polygon::getBoundary);
    inside = keepIn.map(PreparedGeometryFactory::prepare);
    outside =
        List.of(
            keepOuts.stream()
                .map(PreparedGeometryFactory::prepare)
                .toArray(PreparedGeometry[]::new));
  }

  /** Copy shrunk on all sides; throws if no area remains. */
  Fence drawnInBy(double marginM) {
    checkSides(marginM);
    if (marginM == 0.0) {
      return this;
    }
    Optional<Polygon> smaller = keepIn.map(area -> shrunk(area, marginM));
    List<Polygon> larger =
        List.of(
            keepOuts.stream().map(each -> (Polygon) each.buffer(marginM)).toArray(Polygon[]::new));
    return new Fence(
        origin, smaller, larger, shifted(floorM, marginM), shifted(ceilingM, -marginM), rally);
  }

  /**
   * Refuses areas whose borders it would take seconds to move or to join, and the memory of the
   * process.
   */
  private void checkSides(double marginM) {
    List<Polygon> areas = new ArrayList<>(keepOuts);
    keepIn.ifPresent(areas::add);
    List<List<Point>> borders = areas.stream().map(Fence::border).collect(Collectors.toList());
    if (NearSides.count(borders, 2.0 * marginM, MAX_NEAR_SIDES) > MAX_NEAR_SIDES) {
      throw new IllegalArgumentException(
          "more than "
              + MAX_NEAR_SIDES
              + " pairs of sides of its areas cross or are within twice a margin of "
              + CauseText.metres(marginM)
              + ", or it has too many sides to compare them; expected fewer corners");
    }
  }

  private static List<Point> border(Polygon area) {
    List<Point> corners = new ArrayList<>();
    for (Coordinate corner : area.getExteriorRing().getCoordinates()) {
      corners.add(Point.of(corner.x, corner.y, 0.0));
    }
    return corners.isEmpty()
        ? corners
        : corners.subList(1, corners.size()); // the first is the last
  }

  private static Polygon shrunk(Polygon area, double marginM) {
    if (!(area.buffer(-marginM) instanceof Polygon smaller) || smaller.isEmpty()) {
      throw new IllegalArgumentException(
          "a margin of " + CauseText.metres(marginM) + " leaves no connected keep-in area");
    }
    return smaller;
  }

  private static OptionalDouble shifted(OptionalDouble altitude, double byM) {
    return altitude.isPresent() ? OptionalDouble.of(altitude.getAsDouble() + byM) : altitude;
  }

  /**
   * The corners of the keep-in area; empty if there is none.
   *
   * @param local origin of local frames
   */
  public List<Geodetic> corners(Geodetic local) {
    return keepIn.map(area -> corners(area, local)).orElse(List.of());
  }

  /** The corners of each keep-out area; as {@link #corners(Geodetic)}. */
  public List<List<Geodetic>> keepOutCorners(Geodetic local) {
    List<List<Geodetic>> areas = new ArrayList<>();
    keepOuts.forEach(area -> areas.add(corners(area, local)));
    return areas;
  }

  /**
   * The corners of an area in the frame of the fence: longitude and latitude [deg], or east and
   * north of a local plane [m], simplified to a tolerance.
   */
  private List<Point> outline(Polygon area, double toleranceM) {
    List<Point> points = new ArrayList<>();
    for (Coordinate corner : simplified(area, toleranceM)) {
      Point enu = Point.of(corner.x, corner.y, 0.0);
      points.add(
          origin
              .map(place -> onGround(place, enu))
              .map(at -> Point.of(at.longitudeDeg(), at.latitudeDeg(), 0.0))
              .orElse(enu));
    }
    return points.subList(0, Math.max(0, points.size() - 1));
  }

  private static Coordinate[] simplified(Polygon area, double toleranceM) {
    Geometry shown = TopologyPreservingSimplifier.simplify(area, toleranceM);
    return ((Polygon) shown).getExteriorRing().getCoordinates();
  }

  /** Number of corners of all areas, simplified to a tolerance. */
  int corners(double toleranceM) {
    return Stream.concat(keepIn.stream(), keepOuts.stream())
        .mapToInt(area -> simplified(area, toleranceM).length - 1)
        .sum();
  }

  /**
   * The place at altitude 0 below or above a point of the plane, from which the earth curves away.
   */
  private static Geodetic onGround(Geodetic origin, Point enu) {
    Point point = enu;
    for (int i = 0; i < CURVATURE_STEPS; i++) {
      double altitudeM = origin.fromEnu(point).altitudeM() - origin.altitudeM();
      point = Point.of(enu.x(), enu.y(), point.z() - altitudeM);
    }
    return origin.fromEnu(point);
  }

  private List<List<Point>> outlines(List<Polygon> areas, double toleranceM) {
    return areas.stream()
        .map(area -> outline(area, toleranceM))
        .filter(outline -> !outline.isEmpty())
        .collect(Collectors.toList());
  }

  /** Outline of the keep-in area, as {@link #frame} has it; empty if there is none. */
  List<List<Point>> keepIn(double toleranceM) {
    return keepIn.map(area -> outlines(List.of(area), toleranceM)).orElse(List.of());
  }

  /** Outlines of the keep-out areas; as {@link #keepIn}. */
  List<List<Point>> keepOut(double toleranceM) {
    return outlines(keepOuts, toleranceM);
  }

  ReferenceFrame frame() {
    return origin.isPresent() ? ReferenceFrame.GLOBAL : ReferenceFrame.LOCAL_ENU;
  }

  private List<Geodetic> corners(Polygon area, Geodetic local) {
    List<Geodetic> corners = new ArrayList<>();
    for (Coordinate corner : area.getExteriorRing().getCoordinates()) {
      corners.add(onGround(origin.orElse(local), Point.of(corner.x, corner.y, 0.0)));
    }
    return corners;
  }

  /** Whether it has an area, besides altitudes and rally points. */
  boolean hasAreas() {
    return keepIn.isPresent() || !keepOuts.isEmpty();
  }

  /** Rally points, usable or not. */
  List<RallyPoint> rally() {
    return rally;
  }

  /** Why a rally point cannot be used; empty if it can. */
  Optional<String> objection(RallyPoint point) {
    if (!allows(point.place())) {
      return Optional.of("outside the keep-in area, or inside a keep-out one");
    }
    double altitudeM = point.altitudeM().orElse(Double.NaN);
    if (floorM.isPresent() && altitudeM < floorM.getAsDouble()) {
      return Optional.of("below the floor of " + CauseText.metres(floorM.getAsDouble()));
    }
    return ceilingM.isPresent() && altitudeM > ceilingM.getAsDouble()
        ? Optional.of("above the ceiling of " + CauseText.metres(ceilingM.getAsDouble()))
        : Optional.empty();
  }

  /**
   * Position of a state in the fence's plane: x east, y north, z altitude [m]; 0 if it has no
   * altitude.
   *
   * @throws IllegalArgumentException if one is global and the other in a local frame
   */
  Point place(StateInformation state) {
    if (state.referenceFrame().isEarth() != origin.isPresent()) {
      throw new IllegalArgumentException(
          "a state in "
              + state.referenceFrame()
              + " does not fit a fence "
              + (origin.isPresent() ? "on the earth" : "on a local plane"));
    }
    StateInformation own = inFrame(state);
    double x = own.x().orElseThrow();
    double y = own.y().orElseThrow();
    double z = own.z().orElse(0.0);
    if (origin.isEmpty()) {
      return Point.of(x, y, z);
    }
    Point plane = plane(origin.get(), x, y);
    return Point.of(plane.x(), plane.y(), z);
  }

  /** East, north and up velocity of a state [m/s]; 0 for missing components. */
  Point velocity(StateInformation state) {
    StateInformation own = inFrame(state);
    return Point.of(own.xDot().orElse(0.0), own.yDot().orElse(0.0), own.zDot().orElse(0.0));
  }

  private StateInformation inFrame(StateInformation state) {
    return state.referenceFrame().equals(frame()) ? state : state.in(frame());
  }

  /** Projects a global position onto the tangent plane at the origin. */
  static Point plane(Geodetic origin, double longitudeDeg, double latitudeDeg) {
    return origin.enuOf(new Geodetic(longitudeDeg, latitudeDeg, 0.0));
  }

  /** Whether an entire region is allowed, ignoring altitude. */
  boolean allows(Geometry region) {
    return inside.map(area -> area.covers(region)).orElse(true)
        && outside.stream().noneMatch(each -> each.intersects(region));
  }

  /** Whether a position is allowed, ignoring altitude. */
  boolean allows(Point place) {
    return allows(geometry(place));
  }

  /** Distance from an allowed position to the nearest forbidden one [m]. */
  double clearanceM(Point place) {
    Geometry here = geometry(place);
    double clearance = border.map(line -> line.distance(here)).orElse(Double.POSITIVE_INFINITY);
    for (Polygon keepOut : keepOuts) {
      clearance = Math.min(clearance, keepOut.distance(here));
    }
    return clearance;
  }

  private static Geometry geometry(Point place) {
    return new GeometryFactory().createPoint(new Coordinate(place.x(), place.y()));
  }
}
