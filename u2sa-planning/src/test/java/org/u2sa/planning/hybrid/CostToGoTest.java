package org.u2sa.planning.hybrid;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.search.GridFrame;
import org.u2sa.planning.search.Inflation;

class CostToGoTest {
  private static final int ROWS = 40;
  private static final int COLUMNS = 1600;

  /** A wall across the grid: what lies east of it leads to the goal only past the east edge. */
  @Test
  void search_goalBeyondALongGrid_cellsByTheFarEdgeLeadThere() {
    GridFrame frame = new GridFrame(0.0, 0.0, 0.5, ROWS, COLUMNS);
    CostGrid grid = new CostGrid(frame, new Inflation(0.5, 1.0, 3.0));
    grid.update(i -> i % COLUMNS == 1400, i -> false);
    CostToGo toGo = new CostToGo();

    toGo.search(grid, 10.0, -100.0, 0.0);

    assertThat(toGo.metres(10.0, 10.0)).isBetween(100.0, 120.0);
    assertThat(toGo.metres(10.0, 790.0)).isBetween(880.0, 920.0);
    assertThat(toGo.metres(10.0, 710.0)).isBetween(790.0, 900.0);
  }

  @Test
  void search_goalInsideAnObstacle_leadsFromTheFreeCellsWithinTheTolerance() {
    GridFrame frame = new GridFrame(0.0, 0.0, 0.1, 200, 200);
    CostGrid grid = new CostGrid(frame, new Inflation(0.3, 0.6, 3.0));
    grid.update(
        i -> Math.hypot(frame.centreNorthM(i) - 15.0, frame.centreEastM(i) - 10.0) < 0.3,
        i -> false);
    CostToGo toGo = new CostToGo();

    toGo.search(grid, 15.0, 10.0, 0.5);
    assertThat(toGo.metres(5.0, 10.0)).isInfinite(); // all of the disc is closed

    toGo.search(grid, 15.0, 10.0, 1.0);
    assertThat(toGo.metres(5.0, 10.0)).isBetween(9.5, 15.0);
  }
}
