package org.u2sa.planning.seen;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.u2sa.planning.search.GridFrame;

/**
 * Convex outlines of coherent areas of high ground, for planners that plan around shapes: the
 * polygon of the tangents in eight directions (a discrete oriented polytope: Klosowski et al.,
 * Efficient Collision Detection Using Bounding Volume Hierarchies of k-DOPs, 1998), or a disc.
 */
final class GroundOutlines {
  private static final String NAME = "high ground";
  private static final int DIRECTIONS = 8;
  private static final double APART_RAD = 2.0 * Math.PI / DIRECTIONS;
  private static final int MAX_CORNERS = 40; // of all outlines: planners take long among more
  private static final double ROUND = 1.4; // maximum area of a disc, relative to the polygon
  private static final double SMALL_CELLS = 4.0; // radius of areas that are always discs

  private static final double SAME_CELLS = 0.01; // corners closer than that are the same
  private static final double[] COS = new double[DIRECTIONS];
  private static final double[] SIN = new double[DIRECTIONS];

  static {
    for (int i = 0; i < DIRECTIONS; i++) {
      COS[i] = Math.cos(i * APART_RAD);
      SIN[i] = Math.sin(i * APART_RAD);
    }
  }

  private final GridFrame frame;
  private final boolean[] isHigh;
  private final boolean[] left; // cells not yet in an area
  private int[] stack = new int[64];

  private record Outline(int cells, PlanarShape shape) {}

  private GroundOutlines(boolean[] isHigh, GridFrame frame) {
    this.frame = frame;
    this.isHigh = isHigh;
    left = isHigh.clone();
  }

  /** Outlines of the largest areas. */
  static List<PlanarShape> of(boolean[] isHigh, GridFrame frame) {
    GroundOutlines areas = new GroundOutlines(isHigh, frame);
    List<Outline> found = new ArrayList<>();
    for (int i = 0; i < isHigh.length; i++) {
      if (areas.left[i]) {
        found.add(areas.area(i));
      }
    }
    found.sort(Comparator.comparingInt(Outline::cells).reversed());
    List<PlanarShape> largest = new ArrayList<>();
    int corners = 0;
    for (Outline outline : found) {
      corners += outline.shape().count();
      if (corners > MAX_CORNERS) {
        break;
      }
      largest.add(outline.shape());
    }
    return List.copyOf(largest);
  }

  /** Removes the area of a cell and determines its outline. */
  private Outline area(int first) {
    double[] reach = new double[DIRECTIONS]; // of the area in each direction [m]
    Arrays.fill(reach, Double.NEGATIVE_INFINITY);
    int cells = 0;
    int pending = push(first, 0); // number of cells on the stack
    while (pending > 0) {
      int cell = stack[--pending];
      cells++;
      int column = cell % frame.columns();
      for (int row = -1; row <= 1; row++) {
        for (int aside = -1; aside <= 1; aside++) {
          int next = cell + row * frame.columns() + aside;
          boolean exists =
              next >= 0
                  && next < left.length
                  && column + aside >= 0
                  && column + aside < frame.columns();
          if (exists && left[next]) {
            pending = push(next, pending);
          }
        }
      }
      boolean isInside =
          column > 0 && isHigh[cell - 1] && column < frame.columns() - 1 && isHigh[cell + 1];
      if (!isInside) {
        extend(reach, cell);
      }
    }
    return new Outline(cells, shape(reach));
  }

  private int push(int cell, int pending) {
    left[cell] = false;
    if (pending == stack.length) {
      stack = Arrays.copyOf(stack, 2 * pending);
    }
    stack[pending] = cell;
    return pending + 1;
  }

  private void extend(double[] reach, int cell) {
    double half = 0.5 * frame.cellM();
    double north = frame.centreNorthM(cell);
    double east = frame.centreEastM(cell);
    for (int i = 0; i < DIRECTIONS; i++) {
      double along = COS[i] * north + SIN[i] * east;
      reach[i] = Math.max(reach[i], along + half * (Math.abs(COS[i]) + Math.abs(SIN[i])));
    }
  }

  /** Polygon of the tangents, or the disc around it if that is hardly larger. */
  private PlanarShape shape(double[] reach) {
    double[] norths = new double[DIRECTIONS];
    double[] easts = new double[DIRECTIONS];
    double middleNorth = 0.0;
    double middleEast = 0.0;
    for (int i = 0; i < DIRECTIONS; i++) { // the corner of two successive tangents
      int next = (i + 1) % DIRECTIONS;
      double sine = Math.sin(APART_RAD);
      norths[i] = (reach[i] * SIN[next] - reach[next] * SIN[i]) / sine;
      easts[i] = (reach[next] * COS[i] - reach[i] * COS[next]) / sine;
      middleNorth += norths[i] / DIRECTIONS;
      middleEast += easts[i] / DIRECTIONS;
    }
    double radius = 0.0;
    double twiceArea = 0.0;
    for (int i = 0; i < DIRECTIONS; i++) {
      int next = (i + 1) % DIRECTIONS;
      radius = Math.max(radius, Math.hypot(norths[i] - middleNorth, easts[i] - middleEast));
      twiceArea += norths[i] * easts[next] - norths[next] * easts[i];
    }
    boolean isRound = Math.PI * radius * radius < ROUND * 0.5 * twiceArea;
    return isRound || radius < SMALL_CELLS * frame.cellM()
        ? PlanarShape.disc(NAME, middleNorth, middleEast, radius)
        : polygon(norths, easts);
  }

  private PlanarShape polygon(double[] norths, double[] easts) {
    int[] apart =
        IntStream.range(0, DIRECTIONS)
            .filter(
                i -> {
                  int before = (i + DIRECTIONS - 1) % DIRECTIONS;
                  return Math.hypot(norths[i] - norths[before], easts[i] - easts[before])
                      > SAME_CELLS * frame.cellM();
                })
            .toArray();
    return new PlanarShape(
        NAME,
        PlanarShape.Kind.AREA,
        IntStream.of(apart).mapToDouble(i -> norths[i]).toArray(),
        IntStream.of(apart).mapToDouble(i -> easts[i]).toArray(),
        0.0,
        Double.NEGATIVE_INFINITY,
        Double.POSITIVE_INFINITY);
  }
}
