package org.u2sa.planning.local;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.search.GridFrame;
import org.u2sa.planning.search.Inflation;

/** A rover at the origin, pointing north, with a wall across its way to the north. */
class TurnRoomTest {
  private static final BodyDiscs BODY = new BodyDiscs(0.3, 0.3, 0.5); // corners at 0.39 m
  private static final MotionLimits LIMITS =
      new MotionLimits(1.0, 0.8, 1.0, 0.0, true, 1.0, 1.0, 0.05, 0.0, 0.3, 4.0, 0.3, 0.8, 0.2);

  private static TurnRoom at(double wallM, double speedMps, boolean makesRoom) {
    return at(wallM, speedMps, makesRoom, 1.0);
  }

  private static TurnRoom at(double wallM, double speedMps, boolean makesRoom, double reachM) {
    GridFrame frame = new GridFrame(-5.0, -5.0, 0.1, 100, 100);
    CostGrid costs = new CostGrid(frame, new Inflation(0.3, reachM, 3.0));
    costs.update(i -> Math.abs(frame.centreNorthM(i) - wallM) < 0.06, i -> false);
    return new TurnRoom(costs, BODY, LIMITS, new Pose(0.0, 0.0, 0.0), speedMps, makesRoom);
  }

  @Test
  void isTooNarrow_cornersReachTheWall() {
    assertThat(at(0.3, 0.0, false).isTooNarrow()).isTrue();
    assertThat(at(0.6, 0.0, false).isTooNarrow()).isFalse();
  }

  @Test
  void isTooNarrow_rolling_countsFromWhereItStops() {
    assertThat(at(0.8, 0.0, false).isTooNarrow()).isFalse();
    assertThat(at(0.8, 1.0, false).isTooNarrow()).isTrue();
  }

  @Test
  void turnsAtOnce_rolling_onlyWithRoomToDrift() {
    assertThat(at(4.0, 1.0, false).turnsAtOnce()).isTrue();
    assertThat(at(1.3, 1.0, false).turnsAtOnce()).isFalse();
    assertThat(at(0.6, 0.0, false).turnsAtOnce()).isTrue();
  }

  @Test
  void standsFirst_rolling_unlessItAlreadyMakesRoom() {
    assertThat(at(0.3, 0.2, false).standsFirst()).isTrue();
    assertThat(at(0.3, 0.1, false).standsFirst()).isFalse();
    assertThat(at(0.3, -0.5, true).standsFirst()).isFalse();
  }

  @Test
  void isTight_cornersComeCloserThanRoutesDo_untilItKeepsTheWholeClearance() {
    assertThat(at(0.7, 0.0, false).isTight()).isFalse(); // corners 0.18 m from the wall
    assertThat(at(0.6, 0.0, false).isTight()).isTrue();
    assertThat(at(0.7, 0.0, true).isTight()).isTrue();
    assertThat(at(0.9, 0.0, true).isTight()).isFalse();
  }

  /** Greater distances are not distinguished. */
  @Test
  void isTight_distancesReachLessFarThanTheClearance_onlyNearTheWall() {
    assertThat(at(4.0, 0.0, true, 0.5).isTight()).isFalse();
    assertThat(at(0.45, 0.0, true, 0.5).isTight()).isTrue();
  }
}
