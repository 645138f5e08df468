package org.u2sa.world.grid;

import java.util.Arrays;
import java.util.function.IntConsumer;

/** Cells of a window that one scan changes, each once, with their previous values. */
final class MarkedCells {
  private final GridWindow window;
  private final byte unchanged;
  private int[] cells = new int[4_096];
  private byte[] before = new byte[4_096];
  private int count;

  /**
   * @param unchanged value of cells that need no mark, because the scan would not change it
   */
  MarkedCells(GridWindow window, byte unchanged) {
    this.window = window;
    this.unchanged = unchanged;
  }

  /** Marks the cell at a point [fractional cells] if it is in the window and not yet marked. */
  void mark(double column, double row) {
    int side = window.side();
    if (!(column >= 0.0 && row >= 0.0 && column < side && row < side)) {
      return;
    }
    mark((int) row * side + (int) column);
  }

  /** Marks a cell of the window unless already marked. */
  void mark(int cell) {
    byte[] all = window.cells();
    byte held = all[cell];
    if (held == unchanged || held == LogOdds.MARK) {
      return;
    }
    if (count == cells.length) {
      cells = Arrays.copyOf(cells, 2 * count);
      before = Arrays.copyOf(before, 2 * count);
    }
    cells[count] = cell;
    before[count++] = held;
    all[cell] = LogOdds.MARK;
  }

  void forEach(IntConsumer action) {
    for (int i = 0; i < count; i++) {
      action.accept(cells[i]);
    }
  }

  /**
   * Sets the marked cells to new values, indexed by the previous value minus {@link
   * Byte#MIN_VALUE}.
   */
  void replace(byte[] values) {
    byte[] all = window.cells();
    for (int i = 0; i < count; i++) {
      all[cells[i]] = values[before[i] - Byte.MIN_VALUE];
    }
    count = 0;
  }
}
