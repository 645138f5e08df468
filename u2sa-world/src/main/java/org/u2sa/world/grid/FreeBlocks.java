package org.u2sa.world.grid;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;

/**
 * Blocks of 16 × 16 cells of a window that are all at their minimum, so that passing beams change
 * none of them. Beams can then skip the block without reading its cells. A block stays free until
 * it is forgotten, so whoever raises a cell must call {@link #forget}.
 */
final class FreeBlocks {
  /** Cells along each side of a block; a power of two. */
  static final int SIDE = 16;

  private static final int SHIFT = Integer.numberOfTrailingZeros(SIDE);
  private static final byte FREE = 1;
  private static final byte OTHER = 2; // examined during this scan; 0: not yet

  private final GridWindow window;
  private final int side;
  private final int acrossWindow; // blocks, including one that the window cuts off
  private final ByteBuffer cells; // read eight at a time
  private final long freest;
  private final byte[] blocks;
  private long revision; // of the window

  FreeBlocks(GridWindow window, byte freestCell) {
    this.window = window;
    side = window.side();
    revision = window.revision();
    acrossWindow = (side + SIDE - 1) >> SHIFT;
    cells = ByteBuffer.wrap(window.cells()).order(ByteOrder.nativeOrder());
    freest = (freestCell & 0xFFL) * 0x0101_0101_0101_0101L;
    blocks = new byte[acrossWindow * acrossWindow];
  }

  /** Begins a scan: blocks that were not free may be by now. */
  void begin() {
    if (revision != window.revision()) {
      revision = window.revision();
      Arrays.fill(blocks, (byte) 0);
      return;
    }
    for (int i = 0; i < blocks.length; i++) {
      blocks[i] &= FREE;
    }
  }

  /** Forgets the block of a cell, which is raised above the minimum. */
  void forget(int cell) {
    blocks[block(cell % side, cell / side)] = 0;
  }

  /** Whether all cells of the block around a cell are at their minimum; false if it is cut off. */
  boolean isFree(int column, int row) {
    int block = block(column, row);
    if (blocks[block] == 0) {
      blocks[block] = examine(column & -SIDE, row & -SIDE) ? FREE : OTHER;
    }
    return blocks[block] == FREE;
  }

  private int block(int column, int row) {
    return (row >> SHIFT) * acrossWindow + (column >> SHIFT);
  }

  private boolean examine(int firstColumn, int firstRow) {
    if (firstColumn + SIDE > side || firstRow + SIDE > side) {
      return false;
    }
    for (int row = firstRow; row < firstRow + SIDE; row++) {
      int begin = row * side + firstColumn;
      for (int cell = begin; cell < begin + SIDE; cell += Long.BYTES) {
        if (cells.getLong(cell) != freest) {
          return false;
        }
      }
    }
    return true;
  }
}
