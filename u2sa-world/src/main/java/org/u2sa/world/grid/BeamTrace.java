package org.u2sa.world.grid;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;

/**
 * Marks the cells that single beams pass, one per column or row. Most beams pass through space that
 * earlier scans found free; blocks of such cells are skipped without reading them.
 */
final class BeamTrace {
  /** Fixed-point positions in a row or column; doubles would dominate the time of a long beam. */
  private static final int FRACTION_BITS = 32;

  private static final double FRACTIONS = 1L << FRACTION_BITS;

  private final GridWindow window;
  private final byte freest;
  private final FreeBlocks freeBlocks;
  private final MarkedCells passed;

  /**
   * @param freest minimum value of a cell, which a beam does not change
   * @param passed receives the cells
   */
  BeamTrace(GridWindow window, byte freest, MarkedCells passed) {
    this.window = window;
    this.freest = freest;
    this.passed = passed;
    freeBlocks = new FreeBlocks(window, freest);
  }

  void begin() {
    freeBlocks.begin();
  }

  /** Records that a beam has ended in a cell. */
  void raised(int cell) {
    freeBlocks.forget(cell);
  }

  /**
   * Marks the cells between two ranges of a beam.
   *
   * @param x column of the scanner, in fractional cells
   * @param y row of the scanner, in fractional cells
   * @param toX direction of the beam [columns per metre]
   * @param toY direction of the beam [rows per metre]
   * @param near range from which cells are marked [m]
   * @param far range up to which cells are marked [m]
   */
  void mark(double x, double y, double toX, double toY, double near, double far) {
    int side = window.side();
    boolean isSteep = Math.abs(toY) > Math.abs(toX);
    double start = isSteep ? y : x;
    double pace = isSteep ? toY : toX; // cells per metre along the major axis
    int step = pace > 0.0 ? 1 : -1;
    double slope = isSteep ? toX / toY : toY / toX;
    double nearest = Math.floor(start + near * pace); // column or row
    double from = Math.max(0.0, step > 0 ? -nearest : nearest - (side - 1)); // inside the window
    double to =
        Math.min(
            Math.ceil((start + far * pace - nearest - 0.5) * step),
            step > 0 ? side - nearest : nearest + 1.0);
    if (!(from < to)) {
      return;
    }
    double first = nearest + from * step;
    double other = (isSteep ? x : y) + (first + 0.5 - start) * slope;
    long across = (long) Math.floor(other * FRACTIONS);
    long acrossStep = (long) (step * slope * FRACTIONS);
    int count = (int) (to - from);
    if (isInside(across) && isInside(across + (count - 1) * acrossStep)) {
      markBlocks(isSteep, (int) first, step, across, acrossStep, count);
    } else {
      mark(isSteep, (int) first, step, across, acrossStep, count);
    }
  }

  private boolean isInside(long across) {
    return across >= 0L && across >> FRACTION_BITS < window.side();
  }

  /** Marks the cells of a line block by block, except in free blocks. */
  private void markBlocks(
      boolean isSteep, int first, int step, long start, long acrossStep, int count) {
    int along = first;
    long across = start;
    for (int left = count, cells; left > 0; left -= cells) {
      int inBlock = along & (FreeBlocks.SIDE - 1);
      cells = Math.min(left, step > 0 ? FreeBlocks.SIDE - inBlock : inBlock + 1);
      int one = (int) (across >> FRACTION_BITS);
      int two = (int) (across + (cells - 1) * acrossStep >> FRACTION_BITS); // within a block
      boolean isFree =
          isSteep
              ? freeBlocks.isFree(one, along) && freeBlocks.isFree(two, along)
              : freeBlocks.isFree(along, one) && freeBlocks.isFree(along, two);
      if (!isFree) {
        mark(isSteep, along, step, across, acrossStep, cells);
      }
      along += cells * step;
      across += cells * acrossStep;
    }
  }

  /** Marks the cells of a line that are in the window. */
  private void mark(boolean isSteep, int first, int step, long start, long acrossStep, int count) {
    int side = window.side();
    int stride = step * (isSteep ? side : 1);
    int otherStride = isSteep ? 1 : side;
    int cell = first * (isSteep ? side : 1);
    byte[] cells = window.cells();
    long across = start;
    for (int left = count; left > 0; left--) {
      int other = (int) (across >> FRACTION_BITS);
      if (other >= 0 && other < side && cells[cell + other * otherStride] != freest) {
        passed.mark(cell + other * otherStride); // most cells are at their minimum: no call
      }
      cell += stride;
      across += acrossStep;
    }
  }

  /**
   * Blocks of 16 × 16 cells of a window that are all at their minimum, so that passing beams change
   * none of them. Beams can then skip the block without reading its cells. A block stays free until
   * it is forgotten, so code that raises a cell must call {@link #forget}.
   */
  static final class FreeBlocks {
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
    private long revision; // revision of the window

    FreeBlocks(GridWindow window, byte freestCell) {
      this.window = window;
      side = window.side();
      revision = window.revision();
      acrossWindow = (side + SIDE - 1) >> SHIFT;
      cells = ByteBuffer.wrap(window.cells()).order(ByteOrder.nativeOrder());
      freest = (freestCell & 0xFFL) * 0x0101_0101_0101_0101L;
      blocks = new byte[acrossWindow * acrossWindow];
    }

    /** Begins a scan: blocks that were not free may have become free. */
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

    /** Whether all cells of a cell's block are at their minimum; false if the block is cut off. */
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
}
