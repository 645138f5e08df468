package org.u2sa.core.planning.seen;

import java.util.Arrays;
import org.u2sa.core.planning.search.CostGrid;
import org.u2sa.core.planning.search.GridFrame;
import org.u2sa.core.planning.search.RowChange;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.frame.Point;

/**
 * What the World Modeler's grid says of the cells of a plan: each is free, occupied or unknown.
 * Immutable.
 *
 * <p>Both have about the same axes, so the cells of a row of the World Modeler's grid nearly always
 * lie in the same rows of the plan, and those of a column in the same columns. Which ones is found
 * out once for each row and column rather than for each of some hundred thousand cells.
 */
final class GridLayer {
  private static final double SHRUNK_M = 1.0e-6; // a cell that only touches another covers none
  private static final byte FREE = 0;

  private final OccupancyGrid grid;
  private final byte[] cells; // the grid's
  private final int columns;
  private final int rows;
  private final PlanningPlane plane;
  private final GridFrame frame;
  private final double occupiedAbove;
  private final byte threshold;
  private final Point corner;
  private final double northByColumn;
  private final double northByRow;
  private final double eastByColumn;
  private final double eastByRow;
  private final double half;
  private final Spans northward;
  private final Spans eastward;
  private final byte[] said; // as CostGrid's states

  private GridLayer(
      OccupancyGrid grid, PlanningPlane plane, GridFrame frame, double occupiedAbove) {
    this.grid = grid;
    this.plane = plane;
    this.frame = frame;
    this.occupiedAbove = occupiedAbove;
    threshold = threshold(occupiedAbove);
    cells = grid.cells();
    columns = grid.columns();
    rows = grid.rows();
    corner = middle(0, 0);
    Point alongX = middle(1, 0);
    Point alongY = middle(0, 1);
    northByColumn = alongX.x() - corner.x();
    eastByColumn = alongX.y() - corner.y();
    northByRow = alongY.x() - corner.x();
    eastByRow = alongY.y() - corner.y();
    half = 0.5 * grid.resolution() - SHRUNK_M;
    northward =
        new Spans(
            rows,
            row -> north(0, row),
            row -> north(columns - 1, row),
            half,
            frame::row,
            frame.rows());
    eastward =
        new Spans(
            columns,
            column -> east(column, 0),
            column -> east(column, rows - 1),
            half,
            frame::column,
            frame.columns());
    said = new byte[frame.cells()];
    Arrays.fill(said, CostGrid.UNKNOWN);
    draw();
  }

  /** Where the one before was drawn; only what differs is drawn anew. */
  private GridLayer(OccupancyGrid grid, GridLayer before) {
    this.grid = grid;
    plane = before.plane;
    frame = before.frame;
    occupiedAbove = before.occupiedAbove;
    threshold = before.threshold;
    cells = grid.cells();
    columns = before.columns;
    rows = before.rows;
    corner = before.corner;
    northByColumn = before.northByColumn;
    eastByColumn = before.eastByColumn;
    northByRow = before.northByRow;
    eastByRow = before.eastByRow;
    half = before.half;
    northward = before.northward;
    eastward = before.eastward;
    said = before.said.clone();
    redraw(before.cells);
  }

  /** The grid as it lies on the plane, drawn anew only where it is not what was drawn before. */
  static GridLayer of(
      OccupancyGrid grid,
      PlanningPlane plane,
      GridFrame frame,
      double occupiedAbove,
      GridLayer before) {
    boolean alike =
        before != null
            && before.plane == plane
            && before.frame.equals(frame)
            && before.occupiedAbove == occupiedAbove;
    if (alike && before.grid == grid) {
      return before;
    }
    return alike && before.liesAs(grid)
        ? new GridLayer(grid, before)
        : new GridLayer(grid, plane, frame, occupiedAbove);
  }

  /** The state of each cell of the plan, as {@link CostGrid} has them; the caller's own. */
  byte[] states() {
    return said.clone();
  }

  /** Whether another grid's cells lie where this one's do, each row of them in rows of the plan. */
  private boolean liesAs(OccupancyGrid other) {
    return northward.allFit()
        && eastward.allFit()
        && other.columns() == columns
        && other.rows() == rows
        && other.referenceFrame().equals(grid.referenceFrame())
        && other.anchor().equals(grid.anchor())
        && other.left() == grid.left()
        && other.bottom() == grid.bottom()
        && other.resolution() == grid.resolution();
  }

  private void draw() {
    for (int row = 0, k = 0; row < rows; row++) {
      for (int column = 0; column < columns; column++, k++) {
        if (cells[k] != OccupancyGrid.UNKNOWN) {
          byte what = cells[k] >= threshold ? CostGrid.OCCUPIED : FREE;
          if (northward.fits(row) && eastward.fits(column)) {
            fill(
                northward.first(row),
                northward.last(row),
                eastward.first(column),
                eastward.last(column),
                what);
          } else {
            fill(north(column, row), east(column, row), what);
          }
        }
      }
    }
  }

  /** Draws anew the plan's cells under those of the grid that say something else than before. */
  private void redraw(byte[] before) {
    int[] from = new int[frame.rows()]; // by row of the plan: what has changed, in its columns
    int[] to = new int[frame.rows()];
    Arrays.fill(from, frame.columns());
    Arrays.fill(to, -1);
    RowChange change = new RowChange();
    for (int row = 0; row < rows; row++) {
      if (change.find(before, cells, row * columns, columns)) {
        int west = eastward.first(change.first());
        int east = eastward.last(change.last());
        for (int planned = northward.first(row); planned <= northward.last(row); planned++) {
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
    Arrays.fill(said, frame.index(planned, from), frame.index(planned, to) + 1, CostGrid.UNKNOWN);
    int left = columns;
    int right = -1;
    for (int i = from; i <= to; i++) {
      left = Math.min(left, eastward.firstOver(i));
      right = Math.max(right, eastward.lastOver(i));
    }
    for (int row = northward.firstOver(planned); row <= northward.lastOver(planned); row++) {
      for (int column = left; column <= right; column++) {
        byte cell = cells[row * columns + column];
        if (cell != OccupancyGrid.UNKNOWN) {
          fill(
              planned,
              planned,
              Math.max(from, eastward.first(column)),
              Math.min(to, eastward.last(column)),
              cell >= threshold ? CostGrid.OCCUPIED : FREE);
        }
      }
    }
  }

  private double north(int column, int row) {
    return corner.x() + column * northByColumn + row * northByRow;
  }

  private double east(int column, int row) {
    return corner.y() + column * eastByColumn + row * eastByRow;
  }

  private void fill(double north, double east, byte what) {
    fill(
        Math.max(0, frame.row(north - half)),
        Math.min(frame.rows() - 1, frame.row(north + half)),
        Math.max(0, frame.column(east - half)),
        Math.min(frame.columns() - 1, frame.column(east + half)),
        what);
  }

  private void fill(int firstRow, int lastRow, int firstColumn, int lastColumn, byte what) {
    for (int row = firstRow; row <= lastRow; row++) {
      int end = frame.index(row, lastColumn);
      for (int i = frame.index(row, firstColumn); i <= end; i++) {
        if (said[i] == CostGrid.UNKNOWN || what == CostGrid.OCCUPIED) { // it overrules free
          said[i] = what;
        }
      }
    }
  }

  private static byte threshold(double probability) {
    double odds = Math.log(probability / (1.0 - probability)) / OccupancyGrid.LOG_ODDS_STEP;
    return (byte) Math.max(-127.0, Math.min(127.0, Math.ceil(odds)));
  }

  /** Where the middle of a cell lies on the plane. */
  private Point middle(int column, int row) {
    return plane.ned(grid.referenceFrame(), grid.centerOf(column, row));
  }
}
