package org.u2sa.planning.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.BitSet;
import org.junit.jupiter.api.Test;

/** An area of 200 m by 200 m, with a wall of one row of cells, and a goal north of it. */
class WayBeyondTest {
  private static final double CELL_M = 10.0;
  private static final GridFrame FRAME = new GridFrame(0.0, 0.0, CELL_M, 20, 20);
  private static final int WALL_ROW = 10;
  private static final double GOAL_NORTH_M = 175.0;
  private static final double GOAL_EAST_M = 105.0;

  /** A wall from the western edge to a column. */
  private static WayBeyond behindWall(int columns) {
    BitSet closed = new BitSet();
    closed.set(FRAME.index(WALL_ROW, 0), FRAME.index(WALL_ROW, 0) + columns);
    return new WayBeyond(FRAME, closed, GOAL_NORTH_M, GOAL_EAST_M);
  }

  private static double straightM(double north, double east) {
    return Math.hypot(north - GOAL_NORTH_M, east - GOAL_EAST_M);
  }

  @Test
  void lengthM_seesTheGoal_isStraight() {
    WayBeyond way = behindWall(12);

    assertThat(way.lengthM(131.0, 22.0)).isEqualTo(straightM(131.0, 22.0));
    assertThat(way.lengthM(42.0, 198.0)).isEqualTo(straightM(42.0, 198.0));
  }

  /** At most 8 % longer than the shortest: it leads from cell to cell. */
  @Test
  void lengthM_behindTheWall_leadsAroundItsEnd() {
    double aroundM = Math.hypot(105.0 - 25.0, 155.0 - 105.0) + straightM(105.0, 155.0);

    double lengthM = behindWall(15).lengthM(25.0, 105.0);

    assertThat(lengthM).isBetween(aroundM - CELL_M, 1.08 * aroundM);
  }

  @Test
  void lengthM_wallFromEdgeToEdge_isLongerThanAllWaysAndGrowsWithTheDistance() {
    WayBeyond way = behindWall(20);

    double nearM = way.lengthM(95.0, 105.0);
    assertThat(way.reaches(95.0, 105.0)).isFalse();
    assertThat(nearM).isGreaterThan(4.0 * FRAME.rows() * CELL_M);
    assertThat(way.lengthM(75.0, 105.0)).isCloseTo(nearM + 20.0, within(1.0e-9));
  }

  /** A goal low on a slope must not be enclosed by it. */
  @Test
  void reaches_goalAmongClosedCells_is() {
    BitSet closed = new BitSet();
    int row = FRAME.row(GOAL_NORTH_M);
    for (int i = row - 1; i <= row + 1; i++) {
      closed.set(FRAME.index(i, 9), FRAME.index(i, 12));
    }

    assertThat(new WayBeyond(FRAME, closed, GOAL_NORTH_M, GOAL_EAST_M).reaches(15.0, 15.0))
        .isTrue();
  }
}
