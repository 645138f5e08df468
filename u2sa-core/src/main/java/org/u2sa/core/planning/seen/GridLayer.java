package org.u2sa.core.planning.seen;

import java.util.Arrays;
import java.util.function.DoubleToIntFunction;
import java.util.function.IntToDoubleFunction;
import org.u2sa.core.planning.search.CostGrid;
import org.u2sa.core.planning.search.GridFrame;
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
  private final PlanningPlane plane;
  private final GridFrame frame;
  private final double occupiedAbove;
  private final Point corner;
  private final double northByColumn;
  private final double northByRow;
  private final double eastByColumn;
  private final double eastByRow;
  private final double half;
  private final byte[] said; // as CostGrid's states

  private GridLayer(
      OccupancyGrid grid, PlanningPlane plane, GridFrame frame, double occupiedAbove) {
    this.grid = grid;
    this.plane = plane;
    this.frame = frame;
    this.occupiedAbove = occupiedAbove;
    corner = middle(0, 0);
    Point alongX = middle(1, 0);
    Point alongY = middle(0, 1);
    northByColumn = alongX.x() - corner.x();
    eastByColumn = alongX.y() - corner.y();
    northByRow = alongY.x() - corner.x();
    eastByRow = alongY.y() - corner.y();
    half = 0.5 * grid.resolution() - SHRUNK_M;
    said = new byte[frame.cells()];
    Arrays.fill(said, CostGrid.UNKNOWN);
    draw(grid.cells(), grid.columns(), threshold(occupiedAbove));
  }

  /** The grid as it lies on the plane, drawn anew only where it is not what was drawn before. */
  static GridLayer of(
      OccupancyGrid grid,
      PlanningPlane plane,
      GridFrame frame,
      double occupiedAbove,
      GridLayer before) {
    boolean same =
        before != null
            && before.grid == grid
            && before.plane == plane
            && before.frame.equals(frame)
            && before.occupiedAbove == occupiedAbove;
    return same ? before : new GridLayer(grid, plane, frame, occupiedAbove);
  }

  /** The state of each cell of the plan, as {@link CostGrid} has them; the caller's own. */
  byte[] states() {
    return said.clone();
  }

  private void draw(byte[] cells, int columns, byte threshold) {
    if (cells.length == 0) {
      return;
    }
    int rows = cells.length / columns;
    Spans northward =
        new Spans(
            rows, row -> north(0, row), row -> north(columns - 1, row), frame::row, frame.rows());
    Spans eastward =
        new Spans(
            columns,
            column -> east(column, 0),
            column -> east(column, rows - 1),
            frame::column,
            frame.columns());
    for (int row = 0, k = 0; row < rows; row++) {
      for (int column = 0; column < columns; column++, k++) {
        if (cells[k] != OccupancyGrid.UNKNOWN) {
          byte what = cells[k] >= threshold ? CostGrid.OCCUPIED : FREE;
          if (northward.fits[row] && eastward.fits[column]) {
            fill(
                northward.first[row],
                northward.last[row],
                eastward.first[column],
                eastward.last[column],
                what);
          } else {
            fill(north(column, row), east(column, row), what);
          }
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
      for (int i = frame.index(row, firstColumn); i <= frame.index(row, lastColumn); i++) {
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

  /** Which rows (or columns) of the plan each row (or column) of the grid covers. */
  private final class Spans {
    private final int[] first;
    private final int[] last; // below the first if it lies outside
    private final boolean[] fits; // false: not the same from end to end, as the axes differ

    /**
     * @param lines how many rows or columns the grid has
     * @param begin where the first cell of one lies [m]
     * @param end where the last one does; all others lie between both
     * @param index of the plan's row or column there
     * @param limit how many of them the plan has
     */
    Spans(
        int lines,
        IntToDoubleFunction begin,
        IntToDoubleFunction end,
        DoubleToIntFunction index,
        int limit) {
      first = new int[lines];
      last = new int[lines];
      fits = new boolean[lines];
      for (int i = 0; i < lines; i++) {
        double from = begin.applyAsDouble(i);
        double to = end.applyAsDouble(i);
        int low = index.applyAsInt(from - half);
        int high = index.applyAsInt(from + half);
        fits[i] = low == index.applyAsInt(to - half) && high == index.applyAsInt(to + half);
        first[i] = Math.max(0, low);
        last[i] = Math.min(limit - 1, high);
      }
    }
  }
}
