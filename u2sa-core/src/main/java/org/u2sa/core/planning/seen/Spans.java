package org.u2sa.core.planning.seen;

import java.util.Arrays;
import java.util.function.DoubleToIntFunction;
import java.util.function.IntToDoubleFunction;

/**
 * Which rows (or columns) of a plan each row (or column) of the World Modeler's grid covers, and
 * which cover a row of the plan. Immutable.
 */
final class Spans {
  private final int[] first;
  private final int[] last; // below the first if it lies outside
  private final boolean[] fits;
  private final int[] firstOver; // by row of the plan
  private final int[] lastOver; // below the first if none covers it
  private boolean allFit = true;

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
      fits[i] = low == index.applyAsInt(to - half) && high == index.applyAsInt(to + half);
      allFit &= fits[i];
      first[i] = Math.max(0, low);
      last[i] = Math.min(limit - 1, high);
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

  /** Whether the line covers the same rows from end to end; not so where the axes differ. */
  boolean fits(int line) {
    return fits[line];
  }

  /** Whether all of them do. */
  boolean allFit() {
    return allFit;
  }

  /** First row of the grid that covers one of the plan, if all fit. */
  int firstOver(int planned) {
    return firstOver[planned];
  }

  /** The last one; below the first if none does. */
  int lastOver(int planned) {
    return lastOver[planned];
  }
}
