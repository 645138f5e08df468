package org.u2sa.mission;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
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
 * Shortest way over the corners of forbidden areas, at a distance from them (visibility graph,
 * Dijkstra). In a plane [m].
 */
final class FenceRoute {
  /** Maximum corners: the search takes up to half a second with so many. */
  private static final int MAX_CORNERS = 150;

  private static final double CHECKED = 0.9; // of the distance: ways lead over its own corners
  private static final double ROUGH = 0.08; // of the distance, for simplification
  private static final double MITRE = 2.0;
  private static final GeometryFactory FACTORY = new GeometryFactory();

  private final Geometry free;
  private final PreparedGeometry checked;
  private final List<Coordinate> corners = new ArrayList<>();

  /**
   * @param allowed polygonal area, large where there is no limit
   * @param distanceM above 0
   */
  FenceRoute(Geometry allowed, double distanceM) {
    free = smaller(allowed, distanceM);
    checked = PreparedGeometryFactory.prepare(smaller(allowed, CHECKED * distanceM));
    Collections.addAll(
        corners, DouglasPeuckerSimplifier.simplify(free, ROUGH * distanceM).getCoordinates());
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
   * Corners on the way, without start and end; empty if the straight way is free, or if there is
   * none. A start outside the free area first goes to the nearest point of it.
   */
  Optional<List<Coordinate>> between(Coordinate from, Coordinate to) {
    if (free.isEmpty() || corners.size() > MAX_CORNERS || !isFree(to, to)) {
      return Optional.empty();
    }
    List<Coordinate> way = new ArrayList<>();
    Coordinate start = from;
    if (!isFree(from, from)) {
      start = DistanceOp.nearestPoints(free, FACTORY.createPoint(from))[0];
      way.add(start);
    }
    return search(start, to)
        .map(
            rest -> {
              way.addAll(rest);
              return way;
            });
  }

  private boolean isFree(Coordinate a, Coordinate b) {
    Geometry leg =
        a.equals2D(b) ? FACTORY.createPoint(a) : FACTORY.createLineString(new Coordinate[] {a, b});
    return checked.covers(leg);
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
