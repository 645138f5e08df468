package org.u2sa.gcs.report;

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
 * Where something was in the way, as the occupancy grids of a run say: squares of the map that were
 * seen occupied and not seen free later.
 */
final class ObstacleCells {
  private static final double SQUARE_M = 0.2;
  private static final double OCCUPIED = 0.7;
  private static final double FREE = 0.3;
  private static final int MOST = 30_000;

  /** A square, counted from the map's origin. */
  private record Square(int column, int row) {}

  private final Set<Square> squares = new LinkedHashSet<>();

  /**
   * Takes a grid.
   *
   * @param onMap where a point of the grid's frame is on the map; empty if that is not known
   */
  void take(OccupancyGrid grid, Function<Point, Optional<Point>> onMap) {
    for (int row = 0; row < grid.rows(); row++) {
      for (int column = 0; column < grid.columns(); column++) {
        byte cell = grid.cell(column, row);
        if (cell == OccupancyGrid.UNKNOWN) {
          continue;
        }
        double probability = OccupancyGrid.probability(cell);
        if (probability >= OCCUPIED || probability <= FREE) {
          onMap
              .apply(grid.centerOf(column, row))
              .ifPresent(at -> note(square(at), probability >= OCCUPIED));
        }
      }
    }
  }

  private static Square square(Point at) {
    return new Square((int) Math.floor(at.x() / SQUARE_M), (int) Math.floor(at.y() / SQUARE_M));
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
