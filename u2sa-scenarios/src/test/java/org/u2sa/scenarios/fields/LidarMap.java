package org.u2sa.scenarios.fields;

import java.util.Arrays;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.sim.world.Ray;
import org.u2sa.sim.world.World;

/** What a scanner of limited range has seen so far, as a World Modeler's grid would hold it. */
final class LidarMap {
  private static final double CELL_M = 0.1;
  private static final double MARGIN_M = 1.0;
  private static final int BEAMS = 480;
  private static final byte FREE = -40;
  private static final byte FULL = 60;

  private final int size;
  private final byte[] cells;
  private final double rangeM;

  LidarMap(double sideM, double rangeM) {
    size = (int) Math.ceil((sideM + 2.0 * MARGIN_M) / CELL_M);
    cells = new byte[size * size];
    this.rangeM = rangeM;
    Arrays.fill(cells, OccupancyGrid.UNKNOWN);
  }

  /** Looks around from a place. */
  void scan(World world, double east, double north) {
    for (int beam = 0; beam < BEAMS; beam++) {
      double azimuth = 2.0 * Math.PI * beam / BEAMS;
      double far = world.distanceM(Ray.of(Point.of(east, north, 0.3), azimuth, 0.0), rangeM);
      double seen = Math.min(far, rangeM);
      for (double d = 0.0; d < seen; d += 0.5 * CELL_M) {
        mark(east + d * Math.sin(azimuth), north + d * Math.cos(azimuth), FREE);
      }
      if (far <= rangeM) {
        double in = far + 0.01;
        mark(east + in * Math.sin(azimuth), north + in * Math.cos(azimuth), FULL);
      }
    }
  }

  private void mark(double east, double north, byte value) {
    int column = (int) Math.floor((east + MARGIN_M) / CELL_M);
    int row = (int) Math.floor((north + MARGIN_M) / CELL_M);
    if (column >= 0 && row >= 0 && column < size && row < size) {
      int i = row * size + column;
      if (cells[i] != FULL) {
        cells[i] = value;
      }
    }
  }

  OccupancyGrid message() {
    return new OccupancyGrid()
        .anchor(ReferenceFrame.LOCAL_ENU, Point.of(0.0, 0.0, 0.0))
        .corner(-MARGIN_M, -MARGIN_M)
        .resolution(CELL_M)
        .cells(size, cells);
  }
}
