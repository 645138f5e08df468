package org.u2sa.planning.local;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.route.Route;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.search.GridFrame;
import org.u2sa.planning.search.Inflation;
import org.u2sa.service.motion.Drift;

/**
 * A truck at the origin, pointing north, at 0.8 m/s, from which it stops within 0.7 m. Its front is
 * 0.3 m ahead.
 */
class StoppingTest {
  private static final int SIZE = 160;
  private static final double SPEED_MPS = 0.8;

  private final CostGrid costs =
      new CostGrid(new GridFrame(-8.0, -8.0, 0.1, SIZE, SIZE), new Inflation(0.5, 1.0, 3.0));

  private void wall(double south, double west, double east) {
    GridFrame frame = costs.frame();
    costs.update(
        i ->
            frame.centreNorthM(i) >= south
                && frame.centreNorthM(i) <= south + 0.2
                && frame.centreEastM(i) >= west
                && frame.centreEastM(i) <= east,
        i -> false);
  }

  private ArcChooser arcs(double speedMps) {
    return new ArcChooser(
        costs,
        new BodyDiscs(0.3, 0.3, 0.5),
        List.of(),
        new MotionLimits(1.0, 0.8, 0.8, 1.0, true, 1.0, 1.0, 0.05, 0.0, 0.3, 4.0, 0.3, 0.8, 0.2),
        new Pose(0.0, 0.0, 0.0),
        speedMps,
        0L,
        Optional.empty(),
        Optional.empty(),
        Drift.NONE);
  }

  private static RouteTrack southInReverse() {
    Route.Point from = new Route.Point(0.0, 0.0, true);
    return new RouteTrack(Route.of(List.of(from, new Route.Point(-5.0, 0.0, true)), 5.0));
  }

  @Test
  void along_routeLeadsBackAndThereIsRoomToStop_isFollowed() {
    wall(2.0, -3.0, 3.0);
    ArcChoice choice = arcs(SPEED_MPS).along(southInReverse());
    assertThat(choice.kind()).isEqualTo(ArcChoice.Kind.FOLLOW);
    assertThat(choice.backwards()).isTrue();
  }

  @Test
  void along_routeLeadsBackButItCannotStopStraight_turnsAsideFirst() {
    wall(0.8, -3.0, 0.0);
    ArcChoice choice = arcs(SPEED_MPS).along(southInReverse());
    assertThat(choice.kind()).isNotEqualTo(ArcChoice.Kind.FOLLOW);
    assertThat(choice.eastM()).isPositive();
  }

  @Test
  void along_routeLeadsBackAtRestBeforeAWall_isFollowed() {
    wall(0.5, -3.0, 3.0);
    ArcChoice choice = arcs(0.05).along(southInReverse()); // noise of the speed
    assertThat(choice.kind()).isEqualTo(ArcChoice.Kind.FOLLOW);
    assertThat(choice.backwards()).isTrue();
  }

  @ParameterizedTest
  @CsvSource({"-3.0, 0.0, 1", "0.0, 3.0, -1"})
  void withoutRoute_wallAheadOnOneSide_stopsOnAnArcToTheOther(
      double west, double east, double side) {
    wall(0.7, west, east);
    ArcChoice choice = arcs(SPEED_MPS).withoutRoute();
    assertThat(choice.speedMps()).isZero();
    assertThat(Math.signum(choice.eastM())).isEqualTo(side);
  }

  @Test
  void withoutRoute_roomToStop_stopsStraight() {
    wall(1.4, -3.0, 3.0);
    ArcChoice choice = arcs(SPEED_MPS).withoutRoute();
    assertThat(choice.speedMps()).isZero();
    assertThat(choice.eastM()).isCloseTo(0.0, within(1e-9));
  }
}
