package org.u2sa.mission;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.prep.PreparedGeometry;
import org.locationtech.jts.geom.prep.PreparedGeometryFactory;
import org.locationtech.jts.operation.buffer.BufferOp;
import org.locationtech.jts.operation.buffer.BufferParameters;
import org.locationtech.jts.operation.distance.DistanceOp;
import org.locationtech.jts.simplify.DouglasPeuckerSimplifier;

/**
 * Shortest way past the corners of forbidden areas at a distance from them (visibility graph,
 * Dijkstra), in a plane [m].
 */
final class FenceRoute {
  /** Maximum number of corners; the time of the search grows with its square. */
  private static final int MAX_CORNERS = 150;

  private static final double CHECKED = 0.9; // of the distance: ways lead over these corners
  private static final double ROUGH = 0.08; // of the distance, for simplification
  private static final double ROUGHEST = 20.0;
  private static final double MITRE = 2.0;
  private static final double ROUNDING_M = 1e-6;
  private static final GeometryFactory FACTORY = new GeometryFactory();

  private final Geometry allowed;
  private final double distanceM;
  private final Geometry free;
  private final PreparedGeometry checked;
  private final List<Coordinate> corners;

  /**
   * @param allowed polygonal area, large where there is no limit
   * @param distanceM above 0
   */
  FenceRoute(Geometry allowed, double distanceM) {
    this.allowed = allowed;
    this.distanceM = distanceM;
    free = smaller(allowed, distanceM);
    checked = PreparedGeometryFactory.prepare(smaller(allowed, CHECKED * distanceM));
    corners = corners(allowed, distanceM);
  }

  /** Corners of the free area, fewer and farther from the borders if there would be too many. */
  private static List<Coordinate> corners(Geometry allowed, double distanceM) {
    double rough = ROUGH * distanceM;
    Coordinate[] corners;
    do {
      Geometry area = smaller(allowed, (1.0 - ROUGH) * distanceM + rough);
      corners = DouglasPeuckerSimplifier.simplify(area, rough).getCoordinates();
      rough *= 4.0;
    } while (corners.length > MAX_CORNERS && rough < ROUGHEST * distanceM);
    return List.of(corners);
  }

  private static Geometry smaller(Geometry area, double byM) {
    BufferParameters sharp =
        new BufferParameters(
            BufferParameters.DEFAULT_QUADRANT_SEGMENTS,
            BufferParameters.CAP_ROUND,
            BufferParameters.JOIN_MITRE,
            MITRE);
    return BufferOp.bufferOp(area, -byM, sharp);
  }

  /**
   * Corners on the way, without start and end; none if the straight line comes no nearer to a
   * border than its ends, and empty if there is no way. If an end is nearer to a border than the
   * distance, the way leads over the nearest point of the free area. The start may be outside.
   */
  Optional<List<Coordinate>> between(Coordinate from, Coordinate to) {
    if (isStraight(from, to)) {
      return Optional.of(List.of());
    }
    if (free.isEmpty() || corners.size() > MAX_CORNERS || !allowed.covers(leg(to, to))) {
      return Optional.empty();
    }
    Coordinate start = nearestFree(from);
    Coordinate end = nearestFree(to);
    boolean isStartAllowed = allowed.covers(leg(from, from));
    if ((isStartAllowed && !allowed.covers(leg(from, start))) || !allowed.covers(leg(end, to))) {
      return Optional.empty(); // a forbidden area lies between
    }
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

  private Coordinate nearestFree(Coordinate place) {
    return isFree(place, place) ? place : DistanceOp.nearestPoints(free, leg(place, place))[0];
  }

  private boolean isFree(Coordinate a, Coordinate b) {
    return checked.covers(leg(a, b));
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
