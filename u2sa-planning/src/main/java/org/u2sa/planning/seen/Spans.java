package org.u2sa.planning.seen;

import java.util.Arrays;
import java.util.function.DoubleToIntFunction;
import java.util.function.IntToDoubleFunction;

/**
 * Maps each row (or column) of the World Modeler's grid to the rows (or columns) of a plan that it
 * covers from end to end, and back. Immutable.
 */
final class Spans {
  private final int[] first;
  private final int[] last; // less than first if outside
  private final boolean[] fits;
  private final int[] firstOver; // by row of the plan
  private final int[] lastOver; // less than first if not covered
  private boolean isAligned = true;

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
    for (int i = 0; i < lines; i++) {
      double from = begin.applyAsDouble(i);
      double to = end.applyAsDouble(i);
      int low = index.applyAsInt(from - half);
      int high = index.applyAsInt(from + half);
      int endLow = index.applyAsInt(to - half);
      int endHigh = index.applyAsInt(to + half);
      fits[i] = low == endLow && high == endHigh;
      isAligned &= Math.abs(endLow - low) <= 1 && Math.abs(endHigh - high) <= 1;
      first[i] = Math.max(0, Math.min(low, endLow));
      last[i] = Math.min(limit - 1, Math.max(high, endHigh));
      for (int k = first[i]; k <= last[i]; k++) {
        firstOver[k] = Math.min(firstOver[k], i);
        lastOver[k] = Math.max(lastOver[k], i);
      }
    }
  }

  /** First row of the plan that a row of the grid covers. */
  int first(int line) {
    return first[line];
  }

  /** Last row of the plan that a row of the grid covers; less than the first if outside. */
  int last(int line) {
    return last[line];
  }

  /** Whether all cells of a line cover the same rows; false where the axes differ. */
  boolean fits(int line) {
    return fits[line];
  }

  /** Whether every line spans at most one row boundary of the plan. */
  boolean isAligned() {
    return isAligned;
  }

  /** First row of the grid with a cell that may cover a row of the plan. */
  int firstOver(int planned) {
    return firstOver[planned];
  }

  /** Last row of the grid with such a cell; less than the first if none. */
  int lastOver(int planned) {
    return lastOver[planned];
  }
}
