package org.u2sa.planning.seen;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.search.GridFrame;

class GridRasterTest {
  private static final GridFrame FRAME = new GridFrame(-5.0, -3.0, 0.25, 48, 40);

  /** What draw must do, cell by cell, without any thought of speed. */
  private static boolean touches(PlanarShape shape, int cell) {
    double half = 0.5 * FRAME.cellM();
    return shape.distanceM(FRAME.centreNorthM(cell), FRAME.centreEastM(cell)) <= half;
  }

  private static PlanarShape random(PlanarShape.Kind kind, int points, Random random) {
    double[] norths = new double[points];
    double[] easts = new double[points];
    for (int i = 0; i < points; i++) {
      norths[i] = -8.0 + 18.0 * random.nextDouble(); // some are outside the grid
      easts[i] = random.nextInt(4) == 0 && i > 0 ? easts[i - 1] : -6.0 + 16.0 * random.nextDouble();
      if (random.nextInt(4) == 0 && i > 0) {
        norths[i] = norths[i - 1];
      }
    }
    return new PlanarShape("shape", kind, norths, easts, random.nextInt(2) * 0.4, -1.0, 1.0);
  }

  @Test
  void draw_anyShape_occupiesTheCellsWithinHalfACell() {
    Random random = new Random(5);
    for (int trial = 0; trial < 200; trial++) {
      for (PlanarShape.Kind kind : PlanarShape.Kind.values()) {
        PlanarShape shape = random(kind, 1 + random.nextInt(5), random);
        GridRaster raster = new GridRaster(FRAME);
        raster.draw(shape);
        for (int cell = 0; cell < FRAME.cells(); cell++) {
          assertThat((raster.states()[cell] & CostGrid.OCCUPIED) != 0)
              .as("%s of %d points, trial %d, cell %d", kind, shape.count(), trial, cell)
              .isEqualTo(touches(shape, cell));
        }
      }
    }
  }
}
