package org.u2sa.planning.seen;

import java.util.Arrays;
import java.util.function.DoubleToIntFunction;
import java.util.function.IntToDoubleFunction;

/**
 * Which rows (or columns) of a plan each row (or column) of the World Modeler's grid covers from
 * end to end, and which cover a row of the plan. Immutable.
 */
final class Spans {
  private final int[] first;
  private final int[] last; // below the first if it lies outside
  private final boolean[] fits;
  private final int[] firstOver; // by row of the plan
  private final int[] lastOver; // below the first if none covers it
  private boolean isAligned = true;

  /**
   * @param lines how many rows or columns the grid has
   * @param begin where the middle of the first cell of one lies [m]
   * @param end where that of its last one does; all others lie between both
   * @param half half the side of a cell [m]
   * @param index of the plan's row or column there
   * @param limit how many of them the plan has
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

  /** First row of the plan that one of the grid covers. */
  int first(int line) {
    return first[line];
  }

  /** The last one; below the first if the line lies outside. */
  int last(int line) {
    return last[line];
  }

  /** Whether each of its cells covers the same rows; not so where the axes differ. */
  boolean fits(int line) {
    return fits[line];
  }

  /** Whether no line crosses the plan's by more than one. */
  boolean isAligned() {
    return isAligned;
  }

  /** First row of the grid of which a cell may cover one of the plan. */
  int firstOver(int planned) {
    return firstOver[planned];
  }

  /** The last one; below the first if none does. */
  int lastOver(int planned) {
    return lastOver[planned];
  }
}
