package org.u2sa.planning.seen;

import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.search.GridFrame;

/** Rasterises shapes, corridors and the World Modeler's grid into cells. */
final class GridRaster {
  private final GridFrame frame;
  private final byte[] states;

  GridRaster(GridFrame frame) {
    this.frame = frame;
    states = new byte[frame.cells()];
  }

  /** Creates a raster with the World Modeler's cells: free, occupied or unknown. */
  GridRaster(GridFrame frame, GridLayer seen) {
    this.frame = frame;
    states = seen.states().clone();
  }

  byte[] states() {
    return states;
  }

  private boolean isOccupied(int index) {
    return (states[index] & CostGrid.OCCUPIED) != 0;
  }

  private void occupy(int index) {
    states[index] |= CostGrid.OCCUPIED;
  }

  /** Marks cells that a shape touches, by their centres and half a cell. */
  void draw(PlanarShape shape) {
    if (shape.kind() == PlanarShape.Kind.AREA) {
      drawArea(shape);
      return;
    }
    boolean isChain = shape.kind() == PlanarShape.Kind.CHAIN && shape.count() > 1;
    int step = isChain ? 1 : 0;
    for (int i = 0; i + step < shape.count(); i++) {
      drawSegment(
          shape.northM(i),
          shape.eastM(i),
          shape.northM(i + step),
          shape.eastM(i + step),
          shape.radiusM());
    }
  }

  private void drawArea(PlanarShape shape) {
    double[] bounds = shape.bounds();
    double half = 0.5 * frame.cellM();
    int top = Math.min(frame.rows() - 1, frame.row(bounds[1] + half));
    int right = Math.min(frame.columns() - 1, frame.column(bounds[3] + half));
    for (int row = Math.max(0, frame.row(bounds[0] - half)); row <= top; row++) {
      for (int c = Math.max(0, frame.column(bounds[2] - half)); c <= right; c++) {
        int i = frame.index(row, c);
        if (!isOccupied(i)
            && shape.distanceM(frame.centreNorthM(i), frame.centreEastM(i)) <= half) {
          occupy(i);
        }
      }
    }
  }

  /** Visits only cells beside the segment, not its whole bounding box. */
  private void drawSegment(double n1, double e1, double n2, double e2, double radiusM) {
    double half = 0.5 * frame.cellM();
    double reach = radiusM + half;
    int top = Math.min(frame.rows() - 1, frame.row(Math.max(n1, n2) + reach));
    for (int row = Math.max(0, frame.row(Math.min(n1, n2) - reach)); row <= top; row++) {
      double north = frame.centreNorthM(frame.index(row, 0));
      double from = eastAt(north - reach, n1, e1, n2, e2);
      double to = eastAt(north + reach, n1, e1, n2, e2);
      int right = Math.min(frame.columns() - 1, frame.column(Math.max(from, to) + reach));
      for (int c = Math.max(0, frame.column(Math.min(from, to) - reach)); c <= right; c++) {
        int i = frame.index(row, c);
        if (!isOccupied(i)
            && PlanarShape.segmentM(north, frame.columnEastM(c), n1, e1, n2, e2) - radiusM
                <= half) {
          occupy(i);
        }
      }
    }
  }

  /** East coordinate of a segment at a given north coordinate, or the nearest one. */
  private static double eastAt(double north, double n1, double e1, double n2, double e2) {
    if (n1 == n2) {
      return north < n1 ? Math.min(e1, e2) : Math.max(e1, e2);
    }
    double share = Math.max(0.0, Math.min(1.0, (north - n1) / (n2 - n1)));
    return e1 + share * (e2 - e1);
  }

  void draw(CorridorLayer corridors) {
    for (int i = 0; i < states.length; i++) {
      if (corridors.isOutside(i)) {
        occupy(i);
      }
    }
  }

  void draw(GroundLayer ground) {
    for (int i = 0; i < states.length; i++) {
      if (ground.isHigh(i)) {
        occupy(i);
      }
    }
  }
}
