package org.u2sa.messages.shape;

import java.util.ArrayList;
import java.util.List;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.LineSegment;
import org.locationtech.jts.geom.LineString;
import org.locationtech.jts.geom.util.LinearComponentExtracter;
import org.locationtech.jts.index.strtree.STRtree;

/**
 * Counts sides of areas that are near each other. Moving the borders by a distance (a buffer) takes
 * some 30 µs for each pair nearer than twice that, and memory, so hostile areas are recognised
 * beforehand.
 */
public final class NearSides {
  private NearSides() {}

  /**
   * Number of pairs nearer to each other than a distance; counting ends above a limit. Pairs of one
   * convex border do not count.
   */
  public static int count(Geometry areas, double distanceM, int limit) {
    STRtree tree = new STRtree();
    List<Side> sides = new ArrayList<>();
    for (Object each : LinearComponentExtracter.getLines(areas)) {
      LineString line = (LineString) each;
      boolean isConvex = line.convexHull().getNumPoints() == line.getNumPoints();
      Coordinate[] corners = line.getCoordinates();
      for (int i = 1; i < corners.length; i++) {
        Side side = new Side(new LineSegment(corners[i - 1], corners[i]), line, isConvex);
        sides.add(side);
        tree.insert(new Envelope(corners[i - 1], corners[i]), side);
      }
    }
    int twice = 0;
    for (int i = 0; i < sides.size() && twice <= 2 * limit; i++) {
      Side side = sides.get(i);
      Envelope around = new Envelope(side.line.p0, side.line.p1);
      around.expandBy(distanceM);
      for (Object other : tree.query(around)) {
        twice += side.isNear((Side) other, distanceM) ? 1 : 0;
      }
    }
    return twice / 2;
  }

  private static final class Side {
    private final LineSegment line;
    private final LineString border;
    private final boolean isConvex;

    Side(LineSegment line, LineString border, boolean isConvex) {
      this.line = line;
      this.border = border;
      this.isConvex = isConvex;
    }

    boolean isNear(Side other, double distanceM) {
      boolean counts = other != this && !(isConvex && border == other.border);
      return counts && line.distance(other.line) < distanceM;
    }
  }
}
