package org.u2sa.mission.returning;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.LineString;
import org.locationtech.jts.geom.prep.PreparedGeometry;
import org.locationtech.jts.geom.prep.PreparedGeometryFactory;
import org.locationtech.jts.geom.util.LinearComponentExtracter;
import org.locationtech.jts.operation.buffer.BufferOp;
import org.locationtech.jts.operation.buffer.BufferParameters;
import org.locationtech.jts.operation.distance.DistanceOp;
import org.locationtech.jts.operation.distance.IndexedFacetDistance;
import org.locationtech.jts.simplify.DouglasPeuckerSimplifier;
import org.locationtech.jts.simplify.TopologyPreservingSimplifier;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.NearSides;

/**
 * Shortest way past the corners of forbidden areas at a distance from them (visibility graph,
 * Dijkstra), in a plane [m].
 */
final class FenceRoute {
  /** Maximum number of corners; the time of the search grows with its square. */
  private static final int MAX_CORNERS = 150;

  private static final int MAX_EXITS = 20; // compared

  private static final int MAX_NEAR_SIDES = 5_000; // pairs

  private static final double CHECKED = 0.9; // of the distance: ways lead over these corners
  private static final double ROUGH = 0.08; // of the distance, for simplification
  private static final double ROUGHEST = 20.0;
  private static final double MITRE = 2.0;
  private static final double ROUNDING_M = 1e-6;
  private static final GeometryFactory FACTORY = new GeometryFactory();

  private final Geometry allowed;
  private final double marginM;
  private final double distanceM;
  private final Geometry free;
  private final PreparedGeometry prepared;
  private final IndexedFacetDistance border;
  private final List<Coordinate> corners;

  /**
   * @param allowed polygonal area, large where there is no limit
   * @param marginM margin by which it is smaller than what is truly allowed
   * @param distanceM above 0
   */
  FenceRoute(Geometry allowed, double marginM, double distanceM) {
    this.allowed = allowed;
    this.marginM = marginM;
    this.distanceM = distanceM;
    Geometry simple = TopologyPreservingSimplifier.simplify(allowed, ROUGH * distanceM);
    free = smaller(simple, distanceM);
    prepared = PreparedGeometryFactory.prepare(allowed);
    border = new IndexedFacetDistance(allowed.getBoundary());
    corners = free.isEmpty() ? List.of() : corners(simple, distanceM);
  }

  /** Corners of the free area, fewer and farther from the borders if there would be too many. */
  private static List<Coordinate> corners(Geometry allowed, double distanceM) {
    double rough = ROUGH * distanceM;
    Coordinate[] corners;
    do {
      Geometry simple = TopologyPreservingSimplifier.simplify(allowed, rough);
      Geometry area = smaller(simple, (1.0 - ROUGH) * distanceM + rough);
      corners = DouglasPeuckerSimplifier.simplify(area, rough).getCoordinates();
      rough *= 4.0;
    } while (corners.length > MAX_CORNERS && rough < ROUGHEST * distanceM);
    return List.of(corners);
  }

  /**
   * Area with its borders moved inwards; empty if too many sides are near each other to do so
   * quickly.
   */
  private static Geometry smaller(Geometry area, double byM) {
    if (NearSides.count(borders(area), 2.0 * byM, MAX_NEAR_SIDES) > MAX_NEAR_SIDES) {
      return FACTORY.createPolygon();
    }
    BufferParameters sharp =
        new BufferParameters(
            BufferParameters.DEFAULT_QUADRANT_SEGMENTS,
            BufferParameters.CAP_ROUND,
            BufferParameters.JOIN_MITRE,
            MITRE);
    return BufferOp.bufferOp(area, -byM, sharp);
  }

  private static List<List<Point>> borders(Geometry area) {
    List<List<Point>> borders = new ArrayList<>();
    for (Object line : LinearComponentExtracter.getLines(area)) {
      List<Point> corners = new ArrayList<>();
      for (Coordinate corner : ((LineString) line).getCoordinates()) {
        corners.add(Point.of(corner.x, corner.y, 0.0));
      }
      borders.add(corners.subList(1, corners.size())); // the first is the last
    }
    return borders;
  }

  /**
   * Corners on the way, without start and end; none if the straight line comes no nearer to a
   * border than its ends, and empty if there is no way. If an end is nearer to a border than the
   * distance, the way leads over the nearest point of the free area that is not beyond a forbidden
   * one. The start may be outside.
   */
  Optional<List<Coordinate>> between(Coordinate from, Coordinate to) {
    if (isStraight(from, to)) {
      return Optional.of(List.of());
    }
    if (free.isEmpty() || corners.size() > MAX_CORNERS || !allowed.covers(leg(to, to))) {
      return Optional.empty();
    }
    Optional<Coordinate> start = exit(from);
    Optional<Coordinate> end = entrance(to, allowed);
    return start.isEmpty() || end.isEmpty()
        ? Optional.empty() // a forbidden area lies between
        : way(from, start.get(), end.get(), to);
  }

  private Optional<List<Coordinate>> way(
      Coordinate from, Coordinate start, Coordinate end, Coordinate to) {
    return search(start, end)
        .map(
            between -> {
              List<Coordinate> way = new ArrayList<>(between);
              if (start != from) {
                way.add(0, start);
              }
              if (end != to) {
                way.add(end);
              }
              return way;
            });
  }

  private boolean isStraight(Coordinate from, Coordinate to) {
    Geometry leg = leg(from, to);
    Geometry border = allowed.getBoundary();
    double nearest =
        Math.min(
            CHECKED * distanceM,
            Math.min(border.distance(leg(from, from)), border.distance(leg(to, to))));
    return allowed.covers(leg) && border.distance(leg) >= nearest - ROUNDING_M;
  }

  /**
   * Free place where the way begins; the leg to it crosses no truly forbidden area unless the
   * vehicle is in one.
   */
  private Optional<Coordinate> exit(Coordinate from) {
    Geometry place = leg(from, from);
    if (allowed.covers(place)) {
      return entrance(from, allowed);
    }
    Geometry whole = marginM > 0.0 ? allowed.buffer(marginM) : allowed;
    if (whole.covers(place)) {
      return entrance(from, whole);
    }
    return entrances(from)
        .limit(MAX_EXITS)
        .min(Comparator.comparingDouble(each -> leg(from, each).difference(whole).getLength()));
  }

  /** Nearest free place that a straight leg reaches without leaving an area. */
  private Optional<Coordinate> entrance(Coordinate place, Geometry area) {
    if (isFree(place, place)) {
      return Optional.of(place);
    }
    PreparedGeometry inside = PreparedGeometryFactory.prepare(area);
    return entrances(place).filter(each -> inside.covers(leg(place, each))).findFirst();
  }

  private Stream<Coordinate> entrances(Coordinate place) {
    Stream<Coordinate> nearest =
        IntStream.range(0, free.getNumGeometries())
            .mapToObj(i -> DistanceOp.nearestPoints(free.getGeometryN(i), leg(place, place))[0]);
    return Stream.concat(nearest, corners.stream())
        .sorted(Comparator.comparingDouble(place::distance));
  }

  private boolean isFree(Coordinate a, Coordinate b) {
    Geometry leg = leg(a, b);
    return prepared.covers(leg) && !border.isWithinDistance(leg, CHECKED * distanceM);
  }

  private static Geometry leg(Coordinate a, Coordinate b) {
    return a.equals2D(b)
        ? FACTORY.createPoint(a)
        : FACTORY.createLineString(new Coordinate[] {a, b});
  }

  private Optional<List<Coordinate>> search(Coordinate from, Coordinate to) {
    List<Coordinate> places = new ArrayList<>(corners);
    places.add(from);
    places.add(to);
    int end = places.size() - 1;
    double[] lengths = new double[places.size()];
    int[] before = new int[places.size()];
    boolean[] settled = new boolean[places.size()];
    Arrays.fill(lengths, Double.POSITIVE_INFINITY);
    lengths[end - 1] = 0.0;
    before[end - 1] = -1;
    while (true) {
      int next = nearest(lengths, settled);
      if (next < 0) {
        return Optional.empty();
      }
      if (next == end) {
        return Optional.of(way(places, before, end));
      }
      settled[next] = true;
      for (int i = 0; i < places.size(); i++) {
        double length = lengths[next] + places.get(next).distance(places.get(i));
        if (!settled[i] && length < lengths[i] && isFree(places.get(next), places.get(i))) {
          lengths[i] = length;
          before[i] = next;
        }
      }
    }
  }

  private static int nearest(double[] lengths, boolean[] settled) {
    int nearest = -1;
    for (int i = 0; i < lengths.length; i++) {
      if (!settled[i]
          && lengths[i] < Double.POSITIVE_INFINITY
          && (nearest < 0 || lengths[i] < lengths[nearest])) {
        nearest = i;
      }
    }
    return nearest;
  }

  private static List<Coordinate> way(List<Coordinate> places, int[] before, int end) {
    List<Coordinate> way = new ArrayList<>();
    for (int i = before[end]; before[i] >= 0; i = before[i]) {
      way.add(0, places.get(i));
    }
    return way;
  }
}
