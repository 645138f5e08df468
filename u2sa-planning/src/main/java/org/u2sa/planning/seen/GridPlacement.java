package org.u2sa.planning.seen;

import java.util.Arrays;
import java.util.function.DoubleToIntFunction;
import java.util.function.IntToDoubleFunction;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.search.GridFrame;

/**
 * Maps cells of a World Modeler's grid to cells of a plan. Immutable.
 *
 * <p>Both have about the same axes, so the cells of a row of the World Modeler's grid nearly always
 * lie in the same rows of the plan, and the cells of a column in the same columns. The mapping is
 * computed once per row and column rather than for each of about a hundred thousand cells.
 */
final class GridPlacement {
  private static final double SHRUNK_M = 1.0e-6; // a cell that only touches another covers none

  private final OccupancyGrid grid;
  private final PlanningPlane plane;
  final GridFrame frame;
  final int columns;
  final int rows;
  private final Point corner;
  private final double northByColumn;
  private final double northByRow;
  private final double eastByColumn;
  private final double eastByRow;
  private final double half;
  final Spans northward; // rows of the plan that rows of the grid cover
  final Spans eastward; // the same for columns

  GridPlacement(OccupancyGrid grid, PlanningPlane plane, GridFrame frame) {
    this.grid = grid;
    this.plane = plane;
    this.frame = frame;
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
  }

  boolean isOn(PlanningPlane otherPlane, GridFrame otherFrame) {
    return plane == otherPlane && frame.equals(otherFrame);
  }

  /** Whether another grid has the same cell positions. */
  boolean isOf(OccupancyGrid other) {
    return other == grid
        || other.columns() == columns
            && other.rows() == rows
            && other.referenceFrame().equals(grid.referenceFrame())
            && other.anchor().equals(grid.anchor())
            && other.left() == grid.left()
            && other.bottom() == grid.bottom()
            && other.resolution() == grid.resolution();
  }

  /** Whether both have about the same axes. */
  boolean isAligned() {
    return northward.isAligned && eastward.isAligned;
  }

  /** First row of the plan that a cell covers. */
  int firstRow(int column, int row) {
    return northward.fits[row]
        ? northward.first[row]
        : Math.max(0, frame.row(north(column, row) - half));
  }

  /** The last one. */
  int lastRow(int column, int row) {
    return northward.fits[row]
        ? northward.last[row]
        : Math.min(frame.rows() - 1, frame.row(north(column, row) + half));
  }

  /** First column of the plan that a cell covers. */
  int firstColumn(int column, int row) {
    return eastward.fits[column]
        ? eastward.first[column]
        : Math.max(0, frame.column(east(column, row) - half));
  }

  /** The last one. */
  int lastColumn(int column, int row) {
    return eastward.fits[column]
        ? eastward.last[column]
        : Math.min(frame.columns() - 1, frame.column(east(column, row) + half));
  }

  private double north(int column, int row) {
    return corner.x() + column * northByColumn + row * northByRow;
  }

  private double east(int column, int row) {
    return corner.y() + column * eastByColumn + row * eastByRow;
  }

  private Point middle(int column, int row) {
    return plane.ned(grid.referenceFrame(), grid.centerOf(column, row));
  }

  /**
   * Maps each row (or column) of the World Modeler's grid to the rows (or columns) of a plan that
   * it covers from end to end, and back. Immutable.
   */
  static final class Spans {
    final int[] first; // row of the plan that a row of the grid covers
    final int[] last; // less than first if outside
    final boolean[] fits; // whether all cells of a line cover the same rows
    final int[] firstOver; // row of the grid that may cover a row of the plan
    final int[] lastOver; // less than first if not covered
    final boolean isAligned; // whether every line spans at most one row boundary of the plan

    /**
     * @param lines number of rows or columns of the grid
     * @param begin centre of the first cell of a line [m]
     * @param end centre of the last cell of a line; all others lie in between
     * @param half half the edge of a cell [m]
     * @param index row or column of the plan at a position
     * @param limit number of rows or columns of the plan
     */
    Spans(
        int lines,
        IntToDoubleFunction begin,
        IntToDoubleFunction end,
        double half,
        DoubleToIntFunction index,
        int limit) {
      first = new int[lines];
      last = new int[lines];
      fits = new boolean[lines];
      firstOver = new int[limit];
      lastOver = new int[limit];
      Arrays.fill(firstOver, lines);
      Arrays.fill(lastOver, -1);
      boolean aligned = true;
      for (int i = 0; i < lines; i++) {
        double from = begin.applyAsDouble(i);
        double to = end.applyAsDouble(i);
        int low = index.applyAsInt(from - half);
        int high = index.applyAsInt(from + half);
        int endLow = index.applyAsInt(to - half);
        int endHigh = index.applyAsInt(to + half);
        fits[i] = low == endLow && high == endHigh;
        aligned &= Math.abs(endLow - low) <= 1 && Math.abs(endHigh - high) <= 1;
        first[i] = Math.max(0, Math.min(low, endLow));
        last[i] = Math.min(limit - 1, Math.max(high, endHigh));
        for (int k = first[i]; k <= last[i]; k++) {
          firstOver[k] = Math.min(firstOver[k], i);
          lastOver[k] = Math.max(lastOver[k], i);
        }
      }
      isAligned = aligned;
    }
  }
}
