package org.u2sa.world.grid;

import org.u2sa.messages.OccupancyGrid;

/**
 * Lookup tables, over a cell's 256 values, of the value after a beam ends in or passes through the
 * cell: adds clamped log odds (Moravec and Elfes, ICRA 1985; bounds after Hornung et al.,
 * "OctoMap", Autonomous Robots 34, 2013, eq. 4, so that a changed map is unlearned as fast as it
 * was learned).
 */
final class LogOdds {
  /** Reserved value that marks the cells changed by the current scan. */
  static final byte MARK = Byte.MAX_VALUE;

  private static final int VALUES = 256;
  private static final int MOST = MARK - 1;
  private static final int LEAST = OccupancyGrid.UNKNOWN + 1;

  private final byte freest;
  private final byte[] passed = new byte[VALUES];
  private final byte[] ended = new byte[VALUES];

  /**
   * @param hit log odds added when a beam ends, positive
   * @param miss log odds subtracted when a beam passes, positive
   * @param min minimum log odds of a cell, negative
   * @param max maximum log odds of a cell, positive
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

  /** Minimum value of a cell, which further passing beams do not change. */
  byte freest() {
    return freest;
  }

  /** Value after a beam has passed, indexed by the previous value minus {@link Byte#MIN_VALUE}. */
  byte[] passed() {
    return passed;
  }

  /** Value after a beam has ended, with the same index. */
  byte[] ended() {
    return ended;
  }
}
