package org.u2sa.planning.search;

/**
 * Square cells on a horizontal plane: rows count northward, columns eastward. Immutable.
 *
 * @param northM southern edge of row 0 [m]
 * @param eastM western edge of column 0 [m]
 * @param cellM edge of a cell [m], above 0
 * @param rows at least 1
 * @param columns at least 1
 */
public record GridFrame(double northM, double eastM, double cellM, int rows, int columns) {
  public GridFrame {
    if (!(cellM > 0.0) || rows < 1 || columns < 1) {
      throw new IllegalArgumentException(
          "a grid of " + rows + " x " + columns + " cells of " + cellM + " m: expected at least 1");
    }
  }

  public static GridFrame around(double northM, double eastM, double cellM, double spanM) {
    int cells = Math.max(1, (int) Math.ceil(spanM / cellM));
    double half = 0.5 * cells * cellM;
    return new GridFrame(northM - half, eastM - half, cellM, cells, cells);
  }

  public int cells() {
    return rows * columns;
  }

  /** Row of a point; outside the grid below 0 or beyond the last. */
  public int row(double pointNorthM) {
    return (int) Math.floor((pointNorthM - northM) / cellM);
  }

  /** Column of a point; outside the grid below 0 or beyond the last. */
  public int column(double pointEastM) {
    return (int) Math.floor((pointEastM - eastM) / cellM);
  }

  public boolean contains(int row, int column) {
    return row >= 0 && row < rows && column >= 0 && column < columns;
  }

  public boolean contains(double pointNorthM, double pointEastM) {
    return contains(row(pointNorthM), column(pointEastM));
  }

  public int index(int row, int column) {
    return row * columns + column;
  }

  /** Index of the cell of a point; −1 outside. */
  public int indexAt(double pointNorthM, double pointEastM) {
    int row = row(pointNorthM);
    int column = column(pointEastM);
    return contains(row, column) ? index(row, column) : -1;
  }

  /** Fractions between which a straight way is inside the grid; if it never is, first > second. */
  double[] sharesInside(double northFromM, double eastFromM, double northToM, double eastToM) {
    double[] shares = {0.0, 1.0};
    clip(shares, northFromM - northM, northToM - northM, rows * cellM);
    clip(shares, eastFromM - eastM, eastToM - eastM, columns * cellM);
    return shares;
  }

  private static void clip(double[] shares, double from, double to, double side) {
    double way = to - from;
    if (way == 0.0) {
      shares[0] = from < 0.0 || from > side ? 2.0 : shares[0];
      return;
    }
    double low = -from / way;
    double high = (side - from) / way;
    shares[0] = Math.max(shares[0], Math.min(low, high));
    shares[1] = Math.min(shares[1], Math.max(low, high));
  }

  /** North of a cell's centre [m]. */
  public double centreNorthM(int index) {
    return northM + (index / columns + 0.5) * cellM;
  }

  /** East of a cell's centre [m]. */
  public double centreEastM(int index) {
    return columnEastM(index % columns);
  }

  /** East of a column's centre [m]. */
  public double columnEastM(int column) {
    return eastM + (column + 0.5) * cellM;
  }
}
