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

    toGo.search(grid, 10.0, -100.0);

    assertThat(toGo.metres(10.0, 10.0)).isBetween(100.0, 120.0);
    assertThat(toGo.metres(10.0, 790.0)).isBetween(880.0, 920.0);
    assertThat(toGo.metres(10.0, 710.0)).isBetween(790.0, 900.0);
  }
}
