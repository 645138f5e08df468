package org.u2sa.vision.line;

import org.u2sa.vision.ground.TopView;

/**
 * Sums of a view's shades over any rectangle of cells by four look-ups (Crow, Summed-area tables,
 * SIGGRAPH 1984), those not seen left out. Reuses its memory.
 */
final class SummedArea {
  private final int rows;
  private final int columns;
  private final int stride;
  private final int[] sums;
  private final int[] counts;

  SummedArea(TopView.Area area) {
    rows = area.rows();
    columns = area.columns();
    stride = columns + 1;
    sums = new int[(rows + 1) * stride];
    counts = new int[(rows + 1) * stride];
  }

  void take(byte[] shades, boolean[] seen) {
    for (int row = 0; row < rows; row++) {
      int sum = 0;
      int count = 0;
      int at = (row + 1) * stride + 1;
      for (int cell = row * columns; cell < (row + 1) * columns; cell++, at++) {
        if (seen[cell]) {
          sum += shades[cell] & 0xFF;
          count++;
        }
        sums[at] = sums[at - stride] + sum;
        counts[at] = counts[at - stride] + count;
      }
    }
  }

  /**
   * Cells seen from a row and column up to others, these excluded; beyond the edge there is none.
   */
  int count(int row, int column, int toRow, int toColumn) {
    return over(counts, row, column, toRow, toColumn);
  }

  /** The sum of their shades. */
  int sum(int row, int column, int toRow, int toColumn) {
    return over(sums, row, column, toRow, toColumn);
  }

  private int over(int[] table, int row, int column, int toRow, int toColumn) {
    int top = Math.max(0, row);
    int left = Math.max(0, column);
    int bottom = Math.min(rows, toRow);
    int right = Math.min(columns, toColumn);
    if (bottom <= top || right <= left) {
      return 0;
    }
    return table[bottom * stride + right]
        - table[top * stride + right]
        - table[bottom * stride + left]
        + table[top * stride + left];
  }
}
