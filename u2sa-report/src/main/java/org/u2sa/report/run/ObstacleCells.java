package org.u2sa.report.run;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.u2sa.interfaces.JsonText;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.frame.Point;

/**
 * Obstacles from the occupancy grids of a run: squares of the map that were observed occupied and
 * not free later.
 */
final class ObstacleCells {
  private static final double SQUARE_M = 0.2;
  private static final double OCCUPIED = 0.7;
  private static final double FREE = 0.3;
  private static final int MOST = 30_000;

  /** Meaning of a cell: +1 occupied, -1 free, 0 neither; indexed by its byte + 128. */
  private static final byte[] VERDICTS = verdicts();

  /** Indexes of a square, from the map's origin. */
  private record Square(int column, int row) {}

  private final Set<Square> squares = new LinkedHashSet<>();

  private static byte[] verdicts() {
    byte[] verdicts = new byte[1 << Byte.SIZE];
    for (int cell = Byte.MIN_VALUE; cell <= Byte.MAX_VALUE; cell++) {
      double probability = OccupancyGrid.probability((byte) cell);
      boolean isKnown = cell != OccupancyGrid.UNKNOWN;
      verdicts[cell - Byte.MIN_VALUE] =
          (byte) (!isKnown ? 0 : probability >= OCCUPIED ? 1 : probability <= FREE ? -1 : 0);
    }
    return verdicts;
  }

  /**
   * Adds a grid. Only its corners are converted to the map, and cells are interpolated: within a
   * grid, the earth is flat to a fraction of a millimetre.
   *
   * @param onMap converts a point of the grid's frame to the map; empty if unknown
   */
  void take(OccupancyGrid grid, Function<Point, Optional<Point>> onMap) {
    int lastColumn = grid.columns() - 1;
    int lastRow = grid.rows() - 1;
    Optional<Point> first = onMap.apply(grid.centerOf(0, 0));
    Optional<Point> right = onMap.apply(grid.centerOf(lastColumn, 0));
    Optional<Point> top = onMap.apply(grid.centerOf(0, lastRow));
    Optional<Point> last = onMap.apply(grid.centerOf(lastColumn, lastRow));
    if (first.isEmpty() || right.isEmpty() || top.isEmpty() || last.isEmpty()) {
      return;
    }
    byte[] cells = grid.cells();
    for (int row = 0, i = 0; row <= lastRow; row++) {
      double up = lastRow == 0 ? 0.0 : row / (double) lastRow;
      double fromEast = between(first.get().x(), top.get().x(), up);
      double fromNorth = between(first.get().y(), top.get().y(), up);
      double toEast = between(right.get().x(), last.get().x(), up);
      double toNorth = between(right.get().y(), last.get().y(), up);
      for (int column = 0; column <= lastColumn; column++, i++) {
        int verdict = VERDICTS[cells[i] - Byte.MIN_VALUE];
        if (verdict != 0) {
          double along = lastColumn == 0 ? 0.0 : column / (double) lastColumn;
          note(
              square(between(fromEast, toEast, along), between(fromNorth, toNorth, along)),
              verdict > 0);
        }
      }
    }
  }

  private static double between(double a, double b, double share) {
    return a + share * (b - a);
  }

  private static Square square(double east, double north) {
    return new Square((int) Math.floor(east / SQUARE_M), (int) Math.floor(north / SQUARE_M));
  }

  private void note(Square square, boolean occupied) {
    if (!occupied) {
      squares.remove(square);
    } else if (squares.size() < MOST) {
      squares.add(square);
    }
  }

  JsonText json() {
    List<Integer> all = new ArrayList<>();
    for (Square square : squares) {
      all.add(square.column());
      all.add(square.row());
    }
    return new JsonText().put("side", SQUARE_M).put("squares", all);
  }
}
