package org.u2sa.vision.line;

import org.u2sa.vision.ground.TopView;

/**
 * Sums a view's shades over any rectangle of cells by four look-ups (Crow, Summed-area tables,
 * SIGGRAPH 1984), excluding invisible cells. Sum and count share a long, with the count in the
 * upper half, so that the same four look-ups yield both. Reuses its buffers.
 */
final class SummedArea {
  private static final int COUNT = 32; // bits below the count

  private final int rows;
  private final int columns;
  private final int stride;
  private final long[] table;

  SummedArea(TopView.Area area) {
    rows = area.rows();
    columns = area.columns();
    stride = columns + 1;
    table = new long[(rows + 1) * stride];
  }

  void take(byte[] shades, boolean[] seen) {
    for (int row = 0; row < rows; row++) {
      long sum = 0L;
      int at = (row + 1) * stride + 1;
      for (int cell = row * columns; cell < (row + 1) * columns; cell++, at++) {
        if (seen[cell]) {
          sum += (1L << COUNT) + (shades[cell] & 0xFF);
        }
        table[at] = table[at - stride] + sum;
      }
    }
  }

  /**
   * Sums over the columns before each column, between two rows, the upper one exclusive; rows
   * beyond the edge are ignored.
   *
   * @param into columns + 1 elements
   */
  void strip(int row, int toRow, long[] into) {
    int top = Math.min(rows, Math.max(0, row)) * stride;
    int bottom = Math.min(rows, Math.max(0, toRow)) * stride;
    for (int column = 0; column < stride; column++) {
      into[column] = table[bottom + column] - table[top + column];
    }
  }

  /** Like {@link #mean(int, int, int, int, int)} in a strip. */
  static double mean(long[] strip, int column, int toColumn, int least) {
    int last = strip.length - 1;
    long right = strip[Math.min(last, Math.max(0, toColumn))];
    return mean(right - strip[Math.min(last, Math.max(0, column))], least);
  }

  private static double mean(long both, int least) {
    int count = (int) (both >>> COUNT);
    return count < least ? -1.0 : (double) (int) both / count;
  }

  /**
   * Mean shade of the visible cells between two rows and columns, the upper ones exclusive; cells
   * beyond the edge are ignored.
   *
   * @param least required number of visible cells, at least 1
   * @return −1 if fewer are visible
   */
  double mean(int row, int column, int toRow, int toColumn, int least) {
    int top = Math.max(0, row);
    int left = Math.max(0, column);
    int bottom = Math.min(rows, toRow);
    int right = Math.min(columns, toColumn);
    if (bottom <= top || right <= left) {
      return -1.0;
    }
    long both =
        table[bottom * stride + right]
            - table[top * stride + right]
            - table[bottom * stride + left]
            + table[top * stride + left];
    return mean(both, least);
  }
}
