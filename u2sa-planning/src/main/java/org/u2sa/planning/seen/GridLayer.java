package org.u2sa.planning.seen;

import java.util.Arrays;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.search.GridFrame;
import org.u2sa.planning.search.RowChange;
import org.u2sa.planning.seen.GridPlacement.Spans;

/**
 * State of the planner's cells according to the World Modeler's grid: free, occupied or unknown.
 * Not thread-safe.
 */
final class GridLayer {
  private static final byte FREE = 0;

  private OccupancyGrid grid;
  private byte[] cells; // cells of the grid
  private final GridPlacement placement;
  private final GridFrame frame;
  private final double occupiedAbove;
  private final byte threshold;
  private final byte[] said; // states, as in CostGrid

  private GridLayer(
      OccupancyGrid grid, GridPlacement placement, double occupiedAbove, byte[] said) {
    this.grid = grid;
    this.placement = placement;
    this.occupiedAbove = occupiedAbove;
    this.said = said;
    cells = grid.cells();
    frame = placement.frame;
    threshold = threshold(occupiedAbove);
  }

  /**
   * Draws a grid that is placed on the plane.
   *
   * @param before previous layer, which this may reuse: only changed cells are redrawn
   */
  static GridLayer of(
      OccupancyGrid grid,
      PlanningPlane plane,
      GridFrame frame,
      double occupiedAbove,
      GridLayer before) {
    boolean alike =
        before != null
            && before.placement.isOn(plane, frame)
            && before.occupiedAbove == occupiedAbove;
    if (alike && before.grid == grid) {
      return before;
    }
    if (alike && before.placement.isAligned() && before.placement.isOf(grid)) {
      before.redraw(grid);
      return before;
    }
    byte[] unknown = new byte[frame.cells()];
    Arrays.fill(unknown, CostGrid.UNKNOWN);
    GridLayer layer =
        new GridLayer(grid, new GridPlacement(grid, plane, frame), occupiedAbove, unknown);
    layer.draw();
    return layer;
  }

  /** State of each cell of the plan, as in {@link CostGrid}; read-only. */
  byte[] states() {
    return said;
  }

  /** Draws runs of equal cells as one; skips the cells outside the plan, possibly millions. */
  private void draw() {
    Spans northward = placement.northward;
    Spans eastward = placement.eastward;
    int west = placement.columns;
    int east = -1;
    for (int planned = 0; planned < frame.columns(); planned++) {
      west = Math.min(west, eastward.firstOver[planned]);
      east = Math.max(east, eastward.lastOver[planned]);
    }
    for (int row = 0; row < placement.rows; row++) {
      if (northward.last[row] < northward.first[row]) {
        continue;
      }
      int base = row * placement.columns;
      for (int from = west, to; from <= east; from = to + 1) {
        to = northward.fits[row] ? lastAlike(row, from, east) : from;
        if (cells[base + from] != OccupancyGrid.UNKNOWN) {
          fill(
              placement.firstRow(from, row),
              placement.lastRow(from, row),
              Math.min(placement.firstColumn(from, row), placement.firstColumn(to, row)),
              Math.max(placement.lastColumn(from, row), placement.lastColumn(to, row)),
              state(cells[base + from]));
        }
      }
    }
  }

  /** Last column of the run of equal cells that starts at a column. */
  private int lastAlike(int row, int from, int east) {
    int base = row * placement.columns;
    byte first = cells[base + from];
    boolean isKnown = first != OccupancyGrid.UNKNOWN;
    boolean isFull = first >= threshold;
    int least = isFull ? threshold : isKnown ? OccupancyGrid.UNKNOWN + 1 : OccupancyGrid.UNKNOWN;
    int most = isFull ? Byte.MAX_VALUE : isKnown ? threshold - 1 : OccupancyGrid.UNKNOWN;
    int end = base + east + 1;
    int k = base + from + 1;
    while (k < end && cells[k] >= least && cells[k] <= most) {
      k++;
    }
    return k - 1 - base;
  }

  /** Redraws the plan's cells under changed cells of the grid. */
  private void redraw(OccupancyGrid newGrid) {
    byte[] before = cells;
    grid = newGrid;
    cells = newGrid.cells();
    Spans northward = placement.northward;
    Spans eastward = placement.eastward;
    int[] from = new int[frame.rows()]; // changed column range, by row of the plan
    int[] to = new int[frame.rows()];
    Arrays.fill(from, frame.columns());
    Arrays.fill(to, -1);
    RowChange change = new RowChange();
    for (int row = 0; row < placement.rows; row++) {
      if (change.find(before, cells, row * placement.columns, placement.columns)) {
        int west = eastward.first[change.first()];
        int east = eastward.last[change.last()];
        for (int planned = northward.first[row]; planned <= northward.last[row]; planned++) {
          from[planned] = Math.min(from[planned], west);
          to[planned] = Math.max(to[planned], east);
        }
      }
    }
    for (int planned = 0; planned < frame.rows(); planned++) {
      if (from[planned] <= to[planned]) {
        redraw(planned, from[planned], to[planned]);
      }
    }
  }

  private void redraw(int planned, int from, int to) {
    Spans northward = placement.northward;
    Spans eastward = placement.eastward;
    Arrays.fill(said, frame.index(planned, from), frame.index(planned, to) + 1, CostGrid.UNKNOWN);
    int left = placement.columns;
    int right = -1;
    for (int i = from; i <= to; i++) {
      left = Math.min(left, eastward.firstOver[i]);
      right = Math.max(right, eastward.lastOver[i]);
    }
    if (left > right) {
      return;
    }
    byte[] fullest = new byte[right - left + 1]; // by column of the grid
    Arrays.fill(fullest, OccupancyGrid.UNKNOWN);
    for (int row = northward.firstOver[planned]; row <= northward.lastOver[planned]; row++) {
      int base = row * placement.columns;
      boolean fits = northward.fits[row];
      for (int column = left; column <= right; column++) {
        byte cell = cells[base + column];
        if (fits && eastward.fits[column]) {
          fullest[column - left] = (byte) Math.max(fullest[column - left], cell);
        } else if (cell != OccupancyGrid.UNKNOWN) {
          redraw(planned, from, to, row, column);
        }
      }
    }
    redraw(planned, from, to, left, fullest);
  }

  /** Draws the part of a cell that covers the plan. */
  private void redraw(int planned, int from, int to, int row, int column) {
    if (placement.firstRow(column, row) <= planned && placement.lastRow(column, row) >= planned) {
      fill(
          planned,
          planned,
          Math.max(from, placement.firstColumn(column, row)),
          Math.min(to, placement.lastColumn(column, row)),
          state(cells[row * placement.columns + column]));
    }
  }

  /**
   * Draws columns that cover the same columns of the plan in each row: if there are several source
   * cells, the highest occupancy counts; unknown cells have the lowest value.
   */
  private void redraw(int planned, int from, int to, int left, byte[] fullest) {
    Spans eastward = placement.eastward;
    for (int i = from; i <= to; i++) {
      byte most = OccupancyGrid.UNKNOWN;
      for (int column = eastward.firstOver[i]; column <= eastward.lastOver[i]; column++) {
        most = (byte) Math.max(most, fullest[column - left]);
      }
      if (most != OccupancyGrid.UNKNOWN) {
        fill(planned, planned, i, i, state(most));
      }
    }
  }

  private byte state(byte cell) {
    return cell >= threshold ? CostGrid.OCCUPIED : FREE;
  }

  private void fill(int firstRow, int lastRow, int firstColumn, int lastColumn, byte what) {
    for (int row = firstRow; row <= lastRow; row++) {
      int end = frame.index(row, lastColumn);
      for (int i = frame.index(row, firstColumn); i <= end; i++) {
        if (said[i] == CostGrid.UNKNOWN || what == CostGrid.OCCUPIED) { // occupied overrides free
          said[i] = what;
        }
      }
    }
  }

  private static byte threshold(double probability) {
    double odds = Math.log(probability / (1.0 - probability)) / OccupancyGrid.LOG_ODDS_STEP;
    return (byte) Math.max(-127.0, Math.min(127.0, Math.ceil(odds)));
  }
}
