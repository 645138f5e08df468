package org.u2sa.planning.seen;

import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.search.GridFrame;

/**
 * Maps cells of a World Modeler's grid to cells of a plan. Immutable.
 *
 * <p>Both have about the same axes, so the cells of a row of the World Modeler's grid nearly always
 * lie in the same rows of the plan, and those of a column in the same columns. The mapping is
 * computed once per row and column rather than for each of some hundred thousand cells.
 */
final class GridPlacement {
  private static final double SHRUNK_M = 1.0e-6; // a cell that only touches another covers none

  private final OccupancyGrid grid;
  private final PlanningPlane plane;
  private final GridFrame frame;
  private final int columns;
  private final int rows;
  private final Point corner;
  private final double northByColumn;
  private final double northByRow;
  private final double eastByColumn;
  private final double eastByRow;
  private final double half;
  private final Spans northward;
  private final Spans eastward;

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

  /** Whether the placement is for the given plan. */
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

  /** The plan's cells. */
  GridFrame frame() {
    return frame;
  }

  /** Columns of the grid. */
  int columns() {
    return columns;
  }

  /** Rows of the grid. */
  int rows() {
    return rows;
  }

  /** Rows of the plan that rows of the grid cover. */
  Spans northward() {
    return northward;
  }

  /** Columns of the plan that columns of the grid cover. */
  Spans eastward() {
    return eastward;
  }

  /** Whether both have about the same axes. */
  boolean isAligned() {
    return northward.isAligned() && eastward.isAligned();
  }

  /** First row of the plan that a cell covers. */
  int firstRow(int column, int row) {
    return northward.fits(row)
        ? northward.first(row)
        : Math.max(0, frame.row(north(column, row) - half));
  }

  /** The last one. */
  int lastRow(int column, int row) {
    return northward.fits(row)
        ? northward.last(row)
        : Math.min(frame.rows() - 1, frame.row(north(column, row) + half));
  }

  /** First column of the plan that a cell covers. */
  int firstColumn(int column, int row) {
    return eastward.fits(column)
        ? eastward.first(column)
        : Math.max(0, frame.column(east(column, row) - half));
  }

  /** The last one. */
  int lastColumn(int column, int row) {
    return eastward.fits(column)
        ? eastward.last(column)
        : Math.min(frame.columns() - 1, frame.column(east(column, row) + half));
  }

  private double north(int column, int row) {
    return corner.x() + column * northByColumn + row * northByRow;
  }

  private double east(int column, int row) {
    return corner.y() + column * eastByColumn + row * eastByRow;
  }

  /** Centre of a cell on the plane. */
  private Point middle(int column, int row) {
    return plane.ned(grid.referenceFrame(), grid.centerOf(column, row));
  }
}
