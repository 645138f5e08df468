package org.u2sa.vision.lane;

import java.util.HashMap;
import java.util.Map;

/**
 * Ground that a camera has observed from close enough to see paint on it. Where a line ends and the
 * ground beyond was observed, it does not continue. Coordinates in metres from the map's anchor.
 */
final class LookedGround {
  private static final double CELL_M = 0.3;
  private static final double NEAREST_M = 1.3; // closer ground is below the camera's view
  private static final int LOOKS = 3; // images required for certainty
  private static final int MOST =
      40_000; // maximum number of cells; beyond it, distant ones are dropped

  private final Map<Long, Integer> looks = new HashMap<>();

  /** Tests whether a position is unoccluded. */
  interface View {
    boolean isOpen(double x, double y);
  }

  void clear() {
    looks.clear();
  }

  /**
   * Records an image.
   *
   * @param headingRad direction of the image centre, anticlockwise from x
   * @param halfRad half of the opening angle
   */
  void look(double x, double y, double headingRad, double reachM, double halfRad, View view) {
    int span = (int) Math.ceil(reachM / CELL_M);
    long column = cell(x);
    long row = cell(y);
    double cos = Math.cos(headingRad);
    double sin = Math.sin(headingRad);
    double least = Math.cos(Math.min(Math.PI, halfRad));
    for (long r = row - span; r <= row + span; r++) {
      for (long c = column - span; c <= column + span; c++) {
        double toX = (c + 0.5) * CELL_M - x;
        double toY = (r + 0.5) * CELL_M - y;
        double away = Math.sqrt(toX * toX + toY * toY);
        boolean inView =
            away >= NEAREST_M && away <= reachM && toX * cos + toY * sin >= least * away;
        if (inView && view.isOpen(x + toX, y + toY)) {
          looks.merge(CellKey.of(c, r), 1, Integer::sum);
        }
      }
    }
    if (looks.size() > MOST) {
      looks.keySet().removeIf(key -> isFar(key, column, row, 2L * span));
    }
  }

  private static boolean isFar(long key, long column, long row, long span) {
    return Math.abs(CellKey.column(key) - column) > span || Math.abs(CellKey.row(key) - row) > span;
  }

  private static long cell(double metres) {
    return (long) Math.floor(metres / CELL_M);
  }

  /** Whether a position was observed often enough. */
  boolean isKnown(double x, double y) {
    return looks.getOrDefault(CellKey.of(cell(x), cell(y)), 0) >= LOOKS;
  }
}
