package org.u2sa.planning.seen;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.search.GridFrame;

class GridLayerTest {
  private static final double THRESHOLD = 0.5;
  private static final byte FULL = 100;
  private static final byte EMPTY = -100;

  private final PlanningPlane local =
      PlanningPlane.at(new StateInformation().referenceFrame(ReferenceFrame.LOCAL_ENU).x(0).y(0));

  private static PlanningPlane onEarth(double longitude, double latitude) {
    return PlanningPlane.at(
        new StateInformation().referenceFrame(ReferenceFrame.GLOBAL).x(longitude).y(latitude));
  }

  private static OccupancyGrid grid(
      ReferenceFrame frame, Point anchor, double resolution, int columns, byte... cells) {
    return new OccupancyGrid()
        .anchor(frame, anchor)
        .corner(-0.5 * columns * resolution, -0.5 * cells.length / columns * resolution)
        .resolution(resolution)
        .cells(columns, cells);
  }

  private static byte[] random(Random random, int count) {
    byte[] cells = new byte[count];
    for (int i = 0; i < count; i++) {
      int kind = random.nextInt(3);
      cells[i] = kind == 0 ? OccupancyGrid.UNKNOWN : kind == 1 ? FULL : EMPTY;
    }
    return cells;
  }

  /** Cells that mostly say the same as the one before. */
  private static byte[] alike(Random random, int count) {
    byte[] cells = random(random, count);
    for (int i = 1; i < count; i++) {
      cells[i] = random.nextInt(4) > 0 ? cells[i - 1] : cells[i];
    }
    return cells;
  }

  private static void change(Random random, byte[] cells) {
    byte[] other = random(random, cells.length);
    for (int i = random.nextInt(9); i > 0; i--) {
      int changed = random.nextInt(cells.length);
      cells[changed] = other[changed];
    }
  }

  /** What is said of each cell of the plan, each cell of the grid placed by itself. */
  private static String expected(OccupancyGrid grid, PlanningPlane plane, GridFrame frame) {
    ReferenceFrame axes = grid.referenceFrame();
    Point corner = plane.ned(axes, grid.centerOf(0, 0));
    Point alongX = plane.ned(axes, grid.centerOf(1, 0)).minus(corner);
    Point alongY = plane.ned(axes, grid.centerOf(0, 1)).minus(corner);
    double half = 0.5 * grid.resolution() - 1.0e-6;
    char[] said = "?".repeat(frame.cells()).toCharArray();
    for (int row = 0; row < grid.rows(); row++) {
      for (int column = 0; column < grid.columns(); column++) {
        byte cell = grid.cell(column, row);
        double north = corner.x() + column * alongX.x() + row * alongY.x();
        double east = corner.y() + column * alongX.y() + row * alongY.y();
        for (int i = 0; cell != OccupancyGrid.UNKNOWN && i < said.length; i++) {
          int planRow = i / frame.columns();
          int planColumn = i % frame.columns();
          boolean covers =
              frame.row(north - half) <= planRow
                  && frame.row(north + half) >= planRow
                  && frame.column(east - half) <= planColumn
                  && frame.column(east + half) >= planColumn;
          if (covers && said[i] != '#') {
            said[i] = cell == FULL ? '#' : '.';
          }
        }
      }
    }
    return new String(said);
  }

  private static String said(GridLayer layer, GridFrame frame) {
    StringBuilder said = new StringBuilder();
    for (int i = 0; i < frame.cells(); i++) {
      said.append(".#?".charAt(layer.states()[i]));
    }
    return said.toString();
  }

  private static GridLayer layer(OccupancyGrid grid, PlanningPlane plane, GridFrame frame) {
    return GridLayer.of(grid, plane, frame, THRESHOLD, null);
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
  void of_gridOfAnyPlaceAndSizeOnLocalAxes_saysWhatEachCellSays(long seed) {
    Random random = new Random(seed);
    Point anchor = Point.of(random.nextDouble(), random.nextDouble() - 0.5, 0.0);
    double resolution = 0.05 + 0.3 * random.nextDouble();
    GridFrame frame = new GridFrame(-1.0, -1.5, 0.1, 19, 23);
    for (byte[] cells : List.of(random(random, 17 * 13), alike(random, 17 * 13))) {
      OccupancyGrid grid = grid(ReferenceFrame.LOCAL_ENU, anchor, resolution, 17, cells);

      assertThat(said(layer(grid, local, frame), frame)).isEqualTo(expected(grid, local, frame));
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4})
  void of_axesOfOtherDirectionNearThePole_saysWhatEachCellSays(long seed) {
    Random random = new Random(seed);
    Point anchor = Point.of(15.02 + 0.01 * random.nextDouble(), 85.0, 0.0);
    OccupancyGrid grid = grid(ReferenceFrame.GLOBAL, anchor, 0.5, 90, random(random, 90 * 80));
    PlanningPlane plane = onEarth(15.0, 85.0);
    Point middle = plane.ned(ReferenceFrame.GLOBAL, anchor);
    GridFrame frame = GridFrame.around(middle.x(), middle.y(), 0.5, 30.0);

    assertThat(said(layer(grid, plane, frame), frame)).isEqualTo(expected(grid, plane, frame));
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4})
  void of_axesOfTheOppositeDirectionAcrossThePole_saysWhatEachCellSays(long seed) {
    Random random = new Random(seed);
    Point anchor = Point.of(195.0, 89.99999, 0.0); // 1 m from the pole, and so is the plane
    OccupancyGrid grid = grid(ReferenceFrame.GLOBAL, anchor, 0.5, 30, alike(random, 30 * 20));
    PlanningPlane plane = onEarth(15.0, 89.99999);
    Point middle = plane.ned(ReferenceFrame.GLOBAL, anchor);
    GridFrame frame = GridFrame.around(middle.x(), middle.y(), 0.4, 12.0);

    assertThat(said(layer(grid, plane, frame), frame)).isEqualTo(expected(grid, plane, frame));
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
  void of_cellsThatChangeFromGridToGrid_saysWhatEachCellSays(long seed) {
    Random random = new Random(seed);
    Point anchor = Point.of(random.nextDouble(), random.nextDouble() - 0.5, 0.0);
    double resolution = 0.04 + 0.3 * random.nextDouble();
    byte[] cells = random(random, 17 * 13);
    GridFrame frame = new GridFrame(-1.0, -1.5, 0.1, 19, 23);
    GridLayer layer = null;
    for (int step = 0; step < 20; step++) {
      change(random, cells);
      OccupancyGrid grid = grid(ReferenceFrame.LOCAL_ENU, anchor, resolution, 17, cells);

      layer = GridLayer.of(grid, local, frame, THRESHOLD, layer);

      assertThat(said(layer, frame)).isEqualTo(expected(grid, local, frame));
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4})
  void of_cellsThatChangeOnAxesOfSlightlyOtherDirection_saysWhatEachCellSays(long seed) {
    Random random = new Random(seed);
    Point anchor = Point.of(15.002 + 0.001 * random.nextDouble(), 60.0, 0.0);
    PlanningPlane plane = onEarth(15.0, 60.0);
    Point middle = plane.ned(ReferenceFrame.GLOBAL, anchor);
    double half = 0.5 * (1.0 + random.nextDouble());
    GridFrame frame = new GridFrame(middle.x() - half, middle.y() - half, 0.1, 21, 22);
    byte[] cells = random(random, 30 * 28);
    GridLayer layer = null;
    for (int step = 0; step < 10; step++) {
      change(random, cells);
      OccupancyGrid grid = grid(ReferenceFrame.GLOBAL, anchor, 0.1, 30, cells);
      GridPlacement placement = new GridPlacement(grid, plane, frame);
      assertThat(placement.isAligned()).isTrue();

      layer = GridLayer.of(grid, plane, frame, THRESHOLD, layer);

      assertThat(said(layer, frame)).isEqualTo(expected(grid, plane, frame));
    }
  }

  @Test
  void of_gridThatRollsOn_isDrawnWhereItLiesNow() {
    GridFrame frame = new GridFrame(-1.0, -1.0, 0.1, 20, 20);
    OccupancyGrid grid = grid(ReferenceFrame.LOCAL_ENU, Point.of(0, 0, 0), 0.1, 2, FULL, EMPTY);
    OccupancyGrid rolled =
        grid(ReferenceFrame.LOCAL_ENU, Point.of(0, 0, 0), 0.1, 2, FULL, EMPTY).corner(0.3, -0.5);
    OccupancyGrid carried =
        grid(ReferenceFrame.LOCAL_ENU, Point.of(0.4, 0, 0), 0.1, 2, FULL, EMPTY);
    GridLayer before = layer(grid, local, frame);

    for (OccupancyGrid moved : new OccupancyGrid[] {rolled, carried}) {
      assertThat(said(GridLayer.of(moved, local, frame, THRESHOLD, before), frame))
          .isEqualTo(expected(moved, local, frame))
          .isNotEqualTo(said(before, frame));
    }
  }

  @Test
  void of_gridBesideThePlan_saysNothing() {
    GridFrame frame = new GridFrame(100.0, 100.0, 0.1, 5, 5);
    OccupancyGrid grid = grid(ReferenceFrame.LOCAL_ENU, Point.of(0, 0, 0), 0.1, 1, FULL, EMPTY);

    assertThat(said(layer(grid, local, frame), frame)).isEqualTo("?".repeat(25));
  }

  @Test
  void of_nothingChanged_isTheOneBefore() {
    GridFrame frame = new GridFrame(-1.0, -1.0, 0.1, 20, 20);
    OccupancyGrid grid = grid(ReferenceFrame.LOCAL_ENU, Point.of(0, 0, 0), 0.1, 1, FULL, EMPTY);
    GridLayer before = layer(grid, local, frame);

    GridFrame same = new GridFrame(-1.0, -1.0, 0.1, 20, 20);
    assertThat(GridLayer.of(grid, local, same, THRESHOLD, before)).isSameAs(before);
  }

  @Test
  void of_anythingChanged_isDrawnAnew() {
    GridFrame frame = new GridFrame(-1.0, -1.0, 0.1, 20, 20);
    OccupancyGrid grid =
        grid(ReferenceFrame.LOCAL_ENU, Point.of(0, 0, 0), 0.1, 1, (byte) 10, EMPTY);
    GridLayer before = layer(grid, local, frame);
    int full = frame.indexAt(-0.05, 0.0);
    assertThat(before.states()[full]).isEqualTo(CostGrid.OCCUPIED);

    GridLayer stricter = GridLayer.of(grid, local, frame, 0.99, before);
    assertThat(stricter.states()[full]).isNotEqualTo(CostGrid.OCCUPIED);
    GridFrame elsewhere = new GridFrame(50.0, 50.0, 0.1, 20, 20);
    assertThat(GridLayer.of(grid, local, elsewhere, THRESHOLD, before).states()[full])
        .isEqualTo(CostGrid.UNKNOWN);
    OccupancyGrid empty = grid(ReferenceFrame.LOCAL_ENU, Point.of(0, 0, 0), 0.1, 1, EMPTY, EMPTY);
    assertThat(GridLayer.of(empty, local, frame, THRESHOLD, before).states()[full])
        .isNotEqualTo(CostGrid.OCCUPIED);
    OccupancyGrid onGlobe = grid(ReferenceFrame.GLOBAL, Point.of(15, 50, 0), 0.1, 1, FULL, EMPTY);
    GridLayer near = layer(onGlobe, onEarth(15.0, 50.0), frame);
    GridLayer far = GridLayer.of(onGlobe, onEarth(15.1, 50.0), frame, THRESHOLD, near);
    assertThat(near.states()[full]).isEqualTo(CostGrid.OCCUPIED);
    assertThat(far.states()[full]).isNotEqualTo(CostGrid.OCCUPIED);
  }

  @Test
  void states_shapeDrawnIntoARasterOfThem_staySoThatItCanVanish() {
    OccupancyGrid grid =
        grid(ReferenceFrame.LOCAL_ENU, Point.ORIGIN, 1.0, 2, EMPTY, EMPTY, EMPTY, EMPTY);
    GridFrame frame = new GridFrame(-1.0, -1.0, 0.5, 4, 4);
    GridLayer layer = GridLayer.of(grid, local, frame, THRESHOLD, null);
    byte[] before = layer.states().clone();
    GridRaster raster = new GridRaster(frame, layer);
    raster.draw(PlanarShape.disc("post", 0.0, 0.0, 0.3));
    assertThat(raster.states()).isNotEqualTo(before);
    assertThat(layer.states()).isEqualTo(before);
  }
}
