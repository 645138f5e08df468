package org.u2sa.planning.search;

import java.util.Arrays;

/**
 * Distance of each cell from the nearest occupied cell, exact up to a maximum: Felzenszwalb and
 * Huttenlocher, Distance Transforms of Sampled Functions, Theory of Computing 8 (2012), algorithm 1
 * once along columns and once along rows. Local changes are recomputed only around them.
 *
 * <p>Not thread-safe.
 */
final class DistanceField {
  static final byte OCCUPIED = 1; // flag of a cell's state

  private final int rows;
  private final int columns;
  private final int reach;
  private final int farthest; // square of the reach
  private final int[] square; // of the distance [cells²], up to that of the reach
  private final int[] below; // rows to the nearest occupied cell of the same column, at most reach
  private final int[] vertex; // lower envelope: column of each parabola
  private final float[] boundary; // where the envelope's parabolas meet

  /**
   * @param reach maximum distance; larger ones are clamped [cells], at least 1
   */
  DistanceField(int rows, int columns, int reach) {
    this.rows = rows;
    this.columns = columns;
    this.reach = reach;
    farthest = reach * reach;
    square = new int[rows * columns];
    below = new int[rows * columns];
    vertex = new int[columns + 1];
    boundary = new float[columns + 2];
    Arrays.fill(square, farthest);
    Arrays.fill(below, reach);
  }

  /** Distance between centres [cells], at most the reach. */
  float cells(int index) {
    return root(square[index]);
  }

  /** Squared distance, an integer. */
  int square(int index) {
    return square[index];
  }

  /** Distance for a squared distance, as returned by {@link #cells}. */
  static float root(int square) {
    return (float) Math.sqrt(square);
  }

  /**
   * Updates the distances after changes within a rectangle of cells, bounds inclusive.
   *
   * @return the cells whose distance may have changed: first row, first column, last row, last
   *     column
   */
  int[] update(byte[] states, int firstRow, int firstColumn, int lastRow, int lastColumn) {
    int top = Math.max(0, firstRow - reach);
    int bottom = Math.min(rows - 1, lastRow + reach);
    int left = Math.max(0, firstColumn - reach);
    int right = Math.min(columns - 1, lastColumn + reach);
    alongColumns(states, firstRow, lastRow, firstColumn, lastColumn, top, bottom);
    for (int row = top; row <= bottom; row++) {
      alongRow(row, left, right);
    }
    return new int[] {top, left, bottom, right};
  }

  private void alongColumns(
      byte[] states,
      int firstRow,
      int lastRow,
      int firstColumn,
      int lastColumn,
      int top,
      int bottom) {
    int start = Math.max(0, top - reach); // cells farther away have no effect
    int end = Math.min(rows - 1, bottom + reach);
    int[] since = new int[lastColumn - firstColumn + 1];
    Arrays.fill(since, reach);
    for (int row = start; row <= bottom; row++) {
      for (int column = firstColumn; column <= lastColumn; column++) {
        int i = row * columns + column;
        int here =
            (states[i] & OCCUPIED) != 0 ? 0 : Math.min(reach, since[column - firstColumn] + 1);
        since[column - firstColumn] = here;
        if (row >= top) {
          below[i] = here;
        }
      }
    }
    Arrays.fill(since, reach);
    for (int row = end; row >= top; row--) {
      for (int column = firstColumn; column <= lastColumn; column++) {
        int i = row * columns + column;
        int here =
            (states[i] & OCCUPIED) != 0 ? 0 : Math.min(reach, since[column - firstColumn] + 1);
        since[column - firstColumn] = here;
        if (row <= bottom && here < below[i]) {
          below[i] = here;
        }
      }
    }
  }

  /** Computes the lower envelope of the parabolas below² + (column − vertex)² (eq. 2.2). */
  private void alongRow(int row, int left, int right) {
    int base = row * columns;
    int from = Math.max(0, left - reach);
    int to = Math.min(columns - 1, right + reach);
    int count = 0;
    for (int q = from; q <= to; q++) {
      int h = below[base + q];
      if (h >= reach) {
        continue; // none within reach in this column
      }
      float meets = Float.NEGATIVE_INFINITY;
      while (count > 0) {
        int v = vertex[count - 1];
        int hv = below[base + v];
        meets = (h * h + q * q - hv * hv - v * v) / (2.0f * (q - v));
        if (meets > boundary[count - 1]) {
          break;
        }
        count--;
        meets = Float.NEGATIVE_INFINITY;
      }
      vertex[count] = q;
      boundary[count] = meets;
      count++;
    }
    int k = 0;
    for (int q = left; q <= right; q++) {
      if (count == 0) {
        square[base + q] = farthest;
        continue;
      }
      while (k + 1 < count && boundary[k + 1] < q) {
        k++;
      }
      int across = q - vertex[k];
      int h = below[base + vertex[k]];
      square[base + q] = Math.min(farthest, h * h + across * across);
    }
  }
}
