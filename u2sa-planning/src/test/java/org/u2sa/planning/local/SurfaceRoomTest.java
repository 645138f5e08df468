package org.u2sa.planning.local;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.search.GridFrame;
import org.u2sa.planning.search.Inflation;

/** A boat 2.4 m long at the origin, pointing north, that moves 4 m straight ahead. */
class SurfaceRoomTest {
  private static final double QUARTER_RAD = Math.toRadians(90.0);

  private static SurfaceRoom room(double barrelNorth, double barrelEast) {
    GridFrame frame = new GridFrame(-6.0, -6.0, 0.1, 160, 120);
    CostGrid costs = new CostGrid(frame, new Inflation(1.5, 2.0, 3.0));
    costs.update(
        i ->
            Math.hypot(frame.centreNorthM(i) - barrelNorth, frame.centreEastM(i) - barrelEast)
                < 0.2,
        i -> false);
    BodyDiscs body = BodyDiscs.closely(1.2, 1.2, 0.7, 0.1);
    return new SurfaceRoom(costs, body, Point.ORIGIN, 0.0, Point.of(4.0, 0.0, 0.0), 0.1, 0.0);
  }

  /** Beside the bow as it swings, the stern, and the end of the way. */
  @ParameterizedTest
  @CsvSource({"2.5, 0.9", "2.5, -0.9", "4.8, 0.6", "4.0, 1.0"})
  void isEnoughToTurnOnWay_barrelBesideTheWay_isOnlyWhereItStands(double north, double east) {
    SurfaceRoom room = room(north, east);

    assertThat(room.isEnoughToTurn(QUARTER_RAD)).isTrue();
    assertThat(room.isEnoughToTurnOnWay(QUARTER_RAD)).isFalse();
  }

  @Test
  void isEnoughToTurnOnWay_barrelOutOfReach_is() {
    assertThat(room(2.5, 2.0).isEnoughToTurnOnWay(QUARTER_RAD)).isTrue();
  }
}
