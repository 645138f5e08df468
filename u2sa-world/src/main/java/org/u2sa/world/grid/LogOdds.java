package org.u2sa.world.grid;

import org.u2sa.messages.OccupancyGrid;

/**
 * What a cell becomes when a beam ends in it or passes through it, as tables over a cell's 256
 * values: adding log odds within bounds (Moravec and Elfes, ICRA 1985; bounds after Hornung et al.,
 * "OctoMap", Autonomous Robots 34, 2013, eq. 4, so that a map that changes is unlearnt as fast as
 * it was learnt).
 */
final class LogOdds {
  /** A value that no cell has: it marks the cells that the present scan changes. */
  static final byte MARK = Byte.MAX_VALUE;

  private static final int VALUES = 256;
  private static final int MOST = MARK - 1;
  private static final int LEAST = OccupancyGrid.UNKNOWN + 1;

  private final byte freest;
  private final byte[] passed = new byte[VALUES];
  private final byte[] ended = new byte[VALUES];

  /**
   * @param hit log odds that an end adds, positive
   * @param miss log odds that a passage takes away, positive
   * @param min least log odds of a cell, negative
   * @param max largest, positive
   */
  LogOdds(double hit, double miss, double min, double max) {
    int low = Math.max(LEAST, steps(min));
    int high = Math.min(MOST, steps(max));
    freest = (byte) low;
    for (int cell = Byte.MIN_VALUE; cell <= Byte.MAX_VALUE; cell++) {
      int known = cell == OccupancyGrid.UNKNOWN ? 0 : cell;
      passed[cell - Byte.MIN_VALUE] = (byte) Math.max(low, known - Math.max(1, steps(miss)));
      ended[cell - Byte.MIN_VALUE] = (byte) Math.min(high, known + Math.max(1, steps(hit)));
    }
  }

  private static int steps(double logOdds) {
    return (int) Math.round(logOdds / OccupancyGrid.LOG_ODDS_STEP);
  }

  /** A cell that beams have passed through so often that no further one changes it. */
  byte freest() {
    return freest;
  }

  /** A cell after a beam has passed through it, by its value less {@link Byte#MIN_VALUE}. */
  byte[] passed() {
    return passed;
  }

  /** The same after a beam has ended in it. */
  byte[] ended() {
    return ended;
  }
}
