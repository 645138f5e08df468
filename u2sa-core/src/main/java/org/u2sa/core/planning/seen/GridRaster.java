package org.u2sa.core.planning.seen;

import java.util.List;
import org.u2sa.core.planning.search.GridFrame;

/** Which cells of a grid shapes, corridors and the World Modeler's grid occupy. */
final class GridRaster {
  private final GridFrame frame;
  private final boolean[] occupied;
  private GridLayer layer; // null: no grid said anything

  GridRaster(GridFrame frame) {
    this.frame = frame;
    occupied = new boolean[frame.cells()];
  }

  boolean isOccupied(int index) {
    return occupied[index] || layer != null && layer.isOccupied(index);
  }

  boolean isUnknown(int index) {
    return layer != null && layer.isUnknown(index);
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
  void draw(GridLayer grid) {
    layer = grid;
  }
}
