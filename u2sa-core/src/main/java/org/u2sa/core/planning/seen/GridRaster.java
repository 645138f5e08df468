package org.u2sa.core.planning.seen;

import java.util.Arrays;
import java.util.List;
import org.u2sa.core.planning.search.GridFrame;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/** Which cells of a grid shapes, corridors and the World Modeler's grid occupy. */
final class GridRaster {
  private final GridFrame frame;
  private final boolean[] occupied;
  private boolean[] unknown; // null: no grid said anything

  GridRaster(GridFrame frame) {
    this.frame = frame;
    occupied = new boolean[frame.cells()];
  }

  boolean isOccupied(int index) {
    return occupied[index];
  }

  boolean isUnknown(int index) {
    return unknown != null && unknown[index];
  }

  /** Cells that a shape touches, by their centres and half a cell. */
  void draw(PlanarShape shape) {
    double[] bounds = shape.bounds();
    double half = 0.5 * frame.cellM();
    int top = Math.min(frame.rows() - 1, frame.row(bounds[1] + half));
    int right = Math.min(frame.columns() - 1, frame.column(bounds[3] + half));
    for (int row = Math.max(0, frame.row(bounds[0] - half)); row <= top; row++) {
      for (int c = Math.max(0, frame.column(bounds[2] - half)); c <= right; c++) {
        int i = frame.index(row, c);
        if (!occupied[i]) {
          occupied[i] = shape.distanceM(frame.centreNorthM(i), frame.centreEastM(i)) <= half;
        }
      }
    }
  }

  /** Cells that are in none of the corridors. */
  void drawOutside(List<PlanarShape> corridors) {
    for (int i = 0; i < occupied.length; i++) {
      double north = frame.centreNorthM(i);
      double east = frame.centreEastM(i);
      boolean inside = false;
      for (PlanarShape corridor : corridors) {
        inside |= corridor.distanceM(north, east) == 0.0;
      }
      occupied[i] |= !inside;
    }
  }

  /** Cells that the World Modeler has seen, free or occupied; the others are unknown. */
  void draw(OccupancyGrid grid, PlanningPlane plane, double occupiedAbove) {
    if (unknown == null) {
      unknown = new boolean[frame.cells()];
      Arrays.fill(unknown, true);
    }
    byte threshold = threshold(occupiedAbove);
    Point corner = ned(grid, plane, 0, 0);
    Point alongX = ned(grid, plane, 1, 0);
    Point alongY = ned(grid, plane, 0, 1);
    byte[] cells = grid.cells();
    int columns = grid.columns();
    double half = 0.5 * grid.resolution() - 1.0e-6;
    for (int k = 0; k < cells.length; k++) {
      if (cells[k] == OccupancyGrid.UNKNOWN) {
        continue;
      }
      int column = k % columns;
      int row = k / columns;
      double north =
          corner.x() + column * (alongX.x() - corner.x()) + row * (alongY.x() - corner.x());
      double east =
          corner.y() + column * (alongX.y() - corner.y()) + row * (alongY.y() - corner.y());
      fill(north, east, half, cells[k] >= threshold);
    }
  }

  private void fill(double north, double east, double half, boolean full) {
    int lastRow = Math.min(frame.rows() - 1, frame.row(north + half));
    int lastColumn = Math.min(frame.columns() - 1, frame.column(east + half));
    for (int row = Math.max(0, frame.row(north - half)); row <= lastRow; row++) {
      for (int c = Math.max(0, frame.column(east - half)); c <= lastColumn; c++) {
        int i = frame.index(row, c);
        unknown[i] = false;
        occupied[i] |= full;
      }
    }
  }

  private static byte threshold(double probability) {
    double odds = Math.log(probability / (1.0 - probability)) / OccupancyGrid.LOG_ODDS_STEP;
    return (byte) Math.max(-127.0, Math.min(127.0, Math.ceil(odds)));
  }

  /** Where the middle of a cell lies on the plane. */
  private static Point ned(OccupancyGrid grid, PlanningPlane plane, int column, int row) {
    ReferenceFrame frame = grid.referenceFrame();
    return plane.ned(frame, grid.centerOf(column, row));
  }
}
