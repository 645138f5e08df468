package org.u2sa.planning.route;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.route.RouteRequest.Mobility;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.search.GridFrame;
import org.u2sa.planning.search.Inflation;

/** A goal at the middle of a barrel of 0.3 m, such as the object that is the goal. */
class GridRoutesTest {
  private static final double CELL = 0.1;
  private static final double BARREL_M = 0.3;
  private static final double TOLERANCE_M = 1.8;
  private static final double AWAY_M = 4.0;
  private static final BodyDiscs BODY = new BodyDiscs(0.5, 0.5, 0.6);
  private static final Mobility ROVER = new Mobility(BODY, 0.2, 0.0, true);

  private final CostGrid costs =
      new CostGrid(new GridFrame(-6.0, -6.0, CELL, 120, 120), new Inflation(0.8, 1.8, 3.0));

  private static Stream<Arguments> everywhereAround() {
    return Stream.of(GridRoutes.repaired(), GridRoutes.fromScratch())
        .flatMap(
            planner ->
                Stream.of(0.0, 0.9, 1.6, 2.5, 3.1, 4.0, 4.7, 5.5)
                    .map(bearing -> Arguments.of(planner, bearing)));
  }

  private Route plan(GridRoutes planner, Pose start, double north, double east) {
    return planner.plan(
        new RouteRequest(
            start,
            north,
            east,
            OptionalDouble.empty(),
            TOLERANCE_M,
            ROVER,
            costs,
            List.of(),
            List.of(),
            1000));
  }

  @ParameterizedTest
  @MethodSource("everywhereAround")
  void plan_goalIsOccupied_endsOnTheVehiclesSideOfIt(GridRoutes planner, double bearing) {
    GridFrame frame = costs.frame();
    costs.update(
        i -> Math.hypot(frame.centreNorthM(i), frame.centreEastM(i)) < BARREL_M, i -> false);
    Pose start = new Pose(AWAY_M * Math.cos(bearing), AWAY_M * Math.sin(bearing), 0.0);

    Route route = plan(planner, start, 0.0, 0.0);

    Route.Point end = route.points().get(route.points().size() - 1);
    double endM = Math.hypot(end.northM(), end.eastM());
    assertThat(endM).isLessThan(BARREL_M + 1.0);
    assertThat(start.distanceM(end.northM(), end.eastM())).isLessThan(AWAY_M - endM + 0.2);
  }

  /** Between walls, of which the vehicle sees only the surface, open to the south. */
  private void bay(double mouthM) {
    GridFrame frame = costs.frame();
    costs.update(
        i -> {
          double north = frame.centreNorthM(i);
          boolean isBeside = Math.abs(Math.abs(frame.centreEastM(i)) - 0.55) < 0.06;
          boolean isAhead = north > 0.7 && north < 0.8 && Math.abs(frame.centreEastM(i)) < 0.6;
          return isAhead || isBeside && north > mouthM && north < 0.8;
        },
        i -> false);
  }

  @Test
  void plan_startsInClosedCellsOfABay_leavesByItsMouth() {
    bay(-0.9);
    for (GridRoutes planner : List.of(GridRoutes.repaired(), GridRoutes.fromScratch())) {
      Route route = plan(planner, new Pose(0.0, 0.0, 0.0), 0.0, 5.0);
      Route.Point out = route.points().get(1);
      assertThat(out.northM()).isLessThan(-0.9);
      assertThat(Math.abs(out.eastM())).isLessThan(0.3);
    }
  }

  @Test
  void plan_mouthOfTheBayIsFar_doesNotLeadThroughItsWalls() {
    bay(-2.5);

    Route route = plan(GridRoutes.repaired(), new Pose(0.0, 0.0, 0.0), 0.0, 5.0);
    assertThat(route.exists()).isFalse();
    assertThat(route.obstacle()).isEqualTo(GridRoutes.Entrances.ENCLOSED);
  }

  @Test
  void plan_startsOnAnObstacle_leavesItAnyhow() {
    GridFrame frame = costs.frame();
    costs.update(
        i -> Math.hypot(frame.centreNorthM(i), frame.centreEastM(i)) < BARREL_M, i -> false);

    assertThat(plan(GridRoutes.repaired(), new Pose(0.1, 0.0, 0.0), 0.0, 5.0).exists()).isTrue();
  }
}
