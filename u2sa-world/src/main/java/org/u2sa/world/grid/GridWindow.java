package org.u2sa.world.grid;

import java.util.Arrays;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.world.modeller.MapFrame;

/**
 * A square grid that scrolls with the vehicle by whole cells: cells that leave it are discarded,
 * cells that enter it are unknown. Cell (0, 0) has its corner at (left, bottom) cells from the
 * map's anchor.
 */
final class GridWindow {
  private final double resolution;
  private final int side;
  private final byte[] cells;
  private byte[] spare;
  private long left;
  private long bottom;
  private long revision;

  /**
   * @param resolution side of a cell [m]
   * @param side cells along each axis
   */
  GridWindow(double resolution, int side) {
    this.resolution = resolution;
    this.side = side;
    cells = new byte[side * side];
    clear();
  }

  /** Resets all cells to unknown. */
  void clear() {
    Arrays.fill(cells, OccupancyGrid.UNKNOWN);
    revision++;
  }

  /** Recentres on a point [m from the anchor] if it is more than an eighth of the side away. */
  void centre(double x, double y) {
    long newLeft = Math.round(x / resolution - side / 2.0);
    long newBottom = Math.round(y / resolution - side / 2.0);
    if (Math.abs(newLeft - left) > side / 8 || Math.abs(newBottom - bottom) > side / 8) {
      move(newLeft, newBottom);
    }
  }

  /** Moves the corner; cells in both squares keep their position in the world. */
  void move(long newLeft, long newBottom) {
    long dx = newLeft - left;
    long dy = newBottom - bottom;
    left = newLeft;
    bottom = newBottom;
    if (dx == 0 && dy == 0) {
      return;
    }
    if (Math.abs(dx) >= side || Math.abs(dy) >= side) {
      clear();
      return;
    }
    spare = spare == null ? new byte[cells.length] : spare;
    System.arraycopy(cells, 0, spare, 0, cells.length);
    clear();
    int columns = side - (int) Math.abs(dx);
    for (int row = 0; row < side; row++) {
      int from = row + (int) dy;
      if (from >= 0 && from < side) {
        System.arraycopy(
            spare,
            from * side + Math.max(0, (int) dx),
            cells,
            row * side + Math.max(0, (int) -dx),
            columns);
      }
    }
  }

  /** Column of a point, in fractional cells. */
  double column(double x) {
    return x / resolution - left;
  }

  /** Row of a point, in fractional cells. */
  double row(double y) {
    return y / resolution - bottom;
  }

  /** Side of a cell [m]. */
  double resolution() {
    return resolution;
  }

  int side() {
    return side;
  }

  /** All cells, row by row; writable. */
  byte[] cells() {
    return cells;
  }

  /** Increases when cells are cleared, moved or filled, but not when written singly. */
  long revision() {
    return revision;
  }

  /** Converts to a message in the map's frame. */
  OccupancyGrid message(MapFrame frame) {
    return new OccupancyGrid()
        .anchor(frame.frame(), frame.anchor())
        .corner(left * resolution, bottom * resolution)
        .resolution(resolution)
        .cells(side, cells);
  }

  /** Copies the cells of a message with the same frame and resolution. */
  void fill(OccupancyGrid message) {
    byte[] from = message.cells();
    revision++;
    int columns = message.columns();
    long dx = Math.round(message.left() / resolution) - left;
    long dy = Math.round(message.bottom() / resolution) - bottom;
    for (int row = 0; row < message.rows(); row++) {
      long to = row + dy;
      for (int column = 0; column < columns && to >= 0 && to < side; column++) {
        long at = column + dx;
        if (at >= 0 && at < side) {
          cells[(int) (to * side + at)] =
              (byte) Math.min(LogOdds.MARK - 1, from[row * columns + column]);
        }
      }
    }
  }
}
