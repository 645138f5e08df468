package org.u2sa.world.grid;

import java.nio.ByteBuffer;
import java.util.Arrays;

/**
 * Which blocks of 8 × 8 cells of a window hold nothing but the freest value, so that beams need not
 * visit their cells one by one. A block is examined when a beam comes to it, and no more once it is
 * known to be free, until a cell of it is left otherwise.
 */
final class FreestBlocks {
  /** Cells along each axis of a block. */
  static final int SIDE = 8;

  private static final int BITS = 3;
  private static final byte UNSEEN = 0;
  private static final byte FREEST = 1;
  private static final byte MIXED = 2;

  private final GridWindow window;
  private final int side;
  private final ByteBuffer cells; // the window's, compared eight at a time
  private final long eightFreest;
  private final int perRow;
  private final byte[] blocks;
  private long revision;

  /**
   * @param freest value of a cell that no further passage changes
   */
  FreestBlocks(GridWindow window, byte freest) {
    this.window = window;
    side = window.side();
    cells = ByteBuffer.wrap(window.cells());
    eightFreest = (freest & 0xFFL) * 0x0101_0101_0101_0101L;
    perRow = (side + SIDE - 1) >> BITS;
    blocks = new byte[perRow * perRow];
    revision = window.revision();
  }

  /** Begins a scan: what was mixed may be free by now. */
  void begin() {
    if (revision != window.revision()) {
      revision = window.revision();
      Arrays.fill(blocks, UNSEEN);
    }
    for (int i = 0; i < blocks.length; i++) {
      blocks[i] &= FREEST;
    }
  }

  /** Notes that a cell may be left at another value than the freest. */
  void leave(int cell) {
    blocks[(cell / side >> BITS) * perRow + (cell % side >> BITS)] = MIXED;
  }

  /** Whether all cells of the block around a cell were the freest when the scan began. */
  boolean areFreest(int column, int row) {
    int block = (row >> BITS) * perRow + (column >> BITS);
    byte known = blocks[block];
    if (known == UNSEEN) {
      known = examined(column >> BITS << BITS, row >> BITS << BITS);
      blocks[block] = known;
    }
    return known == FREEST;
  }

  /** Whether a cell of a row and the seven after it are the freest. */
  boolean eightAreFreest(int cell) {
    return cells.getLong(cell) == eightFreest;
  }

  private byte examined(int left, int bottom) {
    if (left + SIDE > side || bottom + SIDE > side) {
      return MIXED; // it would reach beyond the window
    }
    int cell = bottom * side + left;
    for (int row = 0; row < SIDE; row++) {
      if (!eightAreFreest(cell + row * side)) {
        return MIXED;
      }
    }
    return FREEST;
  }
}
