package org.u2sa.core.planning.seen;

import java.util.List;
import org.u2sa.core.planning.search.CostGrid;
import org.u2sa.core.planning.search.GridFrame;

/** Which cells of a grid shapes, corridors and the World Modeler's grid occupy. */
final class GridRaster {
  private final GridFrame frame;
  private final byte[] states;

  /** All cells are free. */
  GridRaster(GridFrame frame) {
    this.frame = frame;
    states = new byte[frame.cells()];
  }

  /** The cells are as the World Modeler has seen them: free, occupied or unknown. */
  GridRaster(GridFrame frame, GridLayer seen) {
    this.frame = frame;
    states = seen.states();
  }

  /** The state of each cell, as {@link CostGrid} has them. */
  byte[] states() {
    return states;
  }

  private boolean isOccupied(int index) {
    return (states[index] & CostGrid.OCCUPIED) != 0;
  }

  private void occupy(int index) {
    states[index] |= CostGrid.OCCUPIED;
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
        if (!isOccupied(i)
            && shape.distanceM(frame.centreNorthM(i), frame.centreEastM(i)) <= half) {
          occupy(i);
        }
      }
    }
  }

  /** Cells that are in none of the corridors. */
  void drawOutside(List<PlanarShape> corridors) {
    for (int i = 0; i < states.length; i++) {
      double north = frame.centreNorthM(i);
      double east = frame.centreEastM(i);
      boolean inside = false;
      for (PlanarShape corridor : corridors) {
        inside |= corridor.distanceM(north, east) == 0.0;
      }
      if (!inside) {
        occupy(i);
      }
    }
  }
}
