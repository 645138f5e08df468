package org.u2sa.mission.returning;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.TopologyException;
import org.locationtech.jts.geom.util.PolygonExtracter;
import org.locationtech.jts.operation.overlayng.OverlayNG;
import org.locationtech.jts.operation.overlayng.OverlayNGRobust;
import org.u2sa.messages.Metric;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.safety.FenceState;
import org.u2sa.messages.shape.Polygon;

/**
 * Leads a returning or landing vehicle around the areas that its fence forbids. It keeps the
 * fence's margin as additional distance, but at least twice a waypoint's threshold, and less in
 * narrow passages.
 */
final class ReturnWay {
  private static final double[] SHARES = {1.0, 0.5, 0.25, 0.1}; // of the distance
  private static final double[] FEW_SHARES = {1.0, 0.1};
  private static final int MANY_POINTS = 300; // above this number each share takes longer
  private static final GeometryFactory FACTORY = new GeometryFactory();

  private FenceState fence = new FenceState();

  void see(FenceState inForce) {
    fence = inForce;
  }

  boolean hasAreas() {
    return !fence.keepIn().isEmpty() || !fence.keepOut().isEmpty();
  }

  /**
   * Waypoints on the way to a place, excluding the place; none without a fence, if the frames
   * cannot be compared, or if the straight line is allowed. Empty if the fence leaves no way.
   */
  Optional<List<Waypoint>> between(StateInformation vehicle, Waypoint place) {
    List<Polygon> shapes = new ArrayList<>(fence.keepIn());
    shapes.addAll(fence.keepOut());
    if (shapes.isEmpty()) {
      return Optional.of(List.of());
    }
    ReferenceFrame frame = shapes.get(0).referenceFrame();
    Optional<Point> from = in(frame, vehicle);
    Optional<Point> to = in(frame, at(place));
    if (from.isEmpty() || to.isEmpty()) {
      return Optional.of(List.of());
    }
    Metric metric = Metric.around(frame, from.get());
    double distanceM = Math.max(2.0 * place.horizontalThreshold(), fence.margin());
    Coordinate end = coordinate(metric.metres(to.get()));
    try {
      return corners(allowed(metric, end, distanceM), end, distanceM, fence.margin())
          .map(way -> waypoints(way, metric, frame, place.horizontalThreshold()));
    } catch (TopologyException | IllegalArgumentException e) { // borders that JTS cannot overlay
      return Optional.empty();
    }
  }

  private static List<Waypoint> waypoints(
      List<Coordinate> way, Metric metric, ReferenceFrame frame, double thresholdM) {
    List<Waypoint> waypoints = new ArrayList<>();
    for (Coordinate corner : way) {
      Point point = metric.point(Point.of(corner.x, corner.y, 0.0));
      Waypoint waypoint = new Waypoint().uid("way " + (waypoints.size() + 1));
      waypoint.x(point.x()).y(point.y()).referenceFrame(frame);
      waypoints.add(waypoint.horizontalThreshold(thresholdM));
    }
    return waypoints;
  }

  /** Way at the largest of several distances that permits one, since passages may be narrow. */
  private static Optional<List<Coordinate>> corners(
      Geometry allowed, Coordinate end, double distanceM, double marginM) {
    Coordinate start = new Coordinate(0.0, 0.0);
    for (double share : allowed.getNumPoints() > MANY_POINTS ? FEW_SHARES : SHARES) {
      Optional<List<Coordinate>> way =
          new FenceRoute(allowed, marginM, share * distanceM).between(start, end);
      if (way.isPresent()) {
        return way;
      }
    }
    return Optional.empty();
  }

  private static StateInformation at(Waypoint place) {
    StateInformation state = new StateInformation().referenceFrame(place.referenceFrame());
    place.x().ifPresent(state::x);
    place.y().ifPresent(state::y);
    return state;
  }

  private static Optional<Point> in(ReferenceFrame frame, StateInformation state) {
    ReferenceFrame own = state.referenceFrame();
    boolean isComparable = (own.isEarth() && frame.isEarth()) || (own.isLocal() && frame.isLocal());
    if (!isComparable || state.x().isEmpty() || state.y().isEmpty()) {
      return Optional.empty();
    }
    StateInformation there = state.in(frame);
    return Optional.of(Point.of(there.x().orElseThrow(), there.y().orElseThrow(), 0.0));
  }

  /** The keep-in area, or one that leaves room around all others, without the keep-out areas. */
  private Geometry allowed(Metric metric, Coordinate end, double distanceM) {
    Envelope room = new Envelope(new Coordinate(0.0, 0.0), end);
    List<Geometry> forbidden = new ArrayList<>();
    for (Polygon shape : fence.keepOut()) {
      forbidden.add(polygon(metric, shape));
      room.expandToInclude(forbidden.get(forbidden.size() - 1).getEnvelopeInternal());
    }
    room.expandBy(10.0 * distanceM);
    Geometry allowed =
        fence.keepIn().stream()
            .findFirst()
            .map(shape -> polygon(metric, shape))
            .orElseGet(() -> FACTORY.toGeometry(room));
    if (forbidden.isEmpty()) {
      return allowed;
    }
    Geometry rest =
        OverlayNGRobust.overlay(allowed, OverlayNGRobust.union(forbidden), OverlayNG.DIFFERENCE);
    return FACTORY.buildGeometry(PolygonExtracter.getPolygons(rest)); // without collapsed borders
  }

  private static Geometry polygon(Metric metric, Polygon shape) {
    List<Coordinate> ring = new ArrayList<>();
    shape.points().forEach(point -> ring.add(coordinate(metric.metres(point))));
    ring.add(ring.get(0).copy());
    return FACTORY.createPolygon(ring.toArray(new Coordinate[0])).buffer(0.0);
  }

  private static Coordinate coordinate(Point metres) {
    return new Coordinate(metres.x(), metres.y());
  }
}
