package org.u2sa.planning.route;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.route.GridRoutes.Entrances;
import org.u2sa.planning.route.RouteRequest.Mobility;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.search.GridFrame;
import org.u2sa.planning.search.Inflation;

/** The truck seeks a way backwards into a bay that opens to the north, in parts. */
class HybridRoutesTest {
  private static final double CELL = 0.1;
  private static final BodyDiscs BODY = new BodyDiscs(0.43, 0.1, 0.3);
  private static final Mobility TRUCK = new Mobility(BODY, 0.15, 0.95, true);
  private static final Pose START = new Pose(7.0, 5.0, Math.PI / 2.0);
  private static final int PART = 500;

  private final HybridRoutes planner = new HybridRoutes();
  private boolean gate; // whether something stands in the bay's mouth
  private CostGrid costs = grid();

  private static CostGrid grid() {
    double radius = BODY.radiusM() + 0.15;
    return new CostGrid(
        new GridFrame(0.0, 0.0, CELL, 100, 100), new Inflation(radius, radius + 1.0, 3.0));
  }

  /** Walls of 0.2 m around a bay 1.4 m wide and 1.6 m deep about 5 m east. */
  private boolean isWall(double north, double east) {
    boolean beside = Math.abs(east - 5.0) > 0.7 && Math.abs(east - 5.0) < 0.9;
    boolean behind = Math.abs(east - 5.0) < 0.9 && north < 2.2;
    boolean mouth = gate && Math.abs(east - 5.0) < 0.7 && north > 3.4;
    return north > 2.0 && north < 3.6 && (beside || behind || mouth);
  }

  private void look() {
    GridFrame frame = costs.frame();
    costs.update(i -> isWall(frame.centreNorthM(i), frame.centreEastM(i)), i -> false);
  }

  private RouteRequest request(Pose start, double goalNorth, int effort) {
    return new RouteRequest(
        start,
        goalNorth,
        5.0,
        OptionalDouble.of(0.0),
        0.2,
        TRUCK,
        costs,
        List.of(),
        List.of(),
        effort);
  }

  private Route askUntilAnswered(Pose start) {
    return askUntilAnswered(start, 2.6, PART);
  }

  private Route askUntilAnswered(Pose start, double goalNorth, int part) {
    Route route = planner.plan(request(start, goalNorth, part));
    for (int asked = 1; route.goesOn(); asked++) {
      assertThat(asked).as("requests").isLessThan(200_000 / part + 2);
      route = planner.plan(request(start, goalNorth, part));
    }
    return route;
  }

  /** Begins a search for a goal outside the bay, to which the way is short. */
  private void beginNearby() {
    assertThat(planner.plan(request(START, 6.0, 1)).goesOn()).isTrue();
  }

  @Test
  void plan_inParts_isTheWayOfAWholeSearch() {
    look();
    Route whole = new HybridRoutes().plan(request(START, 2.6, Integer.MAX_VALUE));
    Route first = planner.plan(request(START, 2.6, PART));

    assertThat(first.goesOn()).isTrue();
    assertThat(first.exists()).isFalse();
    assertThat(first.obstacle()).isEqualTo("searching for a route to the goal");
    assertThat(whole.points()).last().matches(Route.Point::backwards);
    assertThat(askUntilAnswered(START)).isEqualTo(whole);
  }

  @Test
  void plan_driftsWithinTwoCells_goesOnAndTheWayBeginsWhereItWas() {
    look();
    beginNearby();
    Route route = askUntilAnswered(new Pose(7.1, 5.1, START.headingRad() + 0.05), 6.0, 1);

    assertThat(route.points().get(0)).isEqualTo(new Route.Point(7.0, 5.0, false));
  }

  @Test
  void plan_vehicleMovesOrTurnsAway_seeksFromThere() {
    look();
    beginNearby();
    Pose moved = new Pose(7.0, 5.25, START.headingRad());
    assertThat(askUntilAnswered(moved, 6.0, 1).points().get(0))
        .isEqualTo(new Route.Point(7.0, 5.25, false));

    beginNearby();
    Pose turned = new Pose(7.0, 5.01, START.headingRad() - 0.1);
    assertThat(askUntilAnswered(turned, 6.0, 1).points().get(0))
        .isEqualTo(new Route.Point(7.0, 5.01, false));
  }

  @Test
  void plan_otherGoal_isNotAnsweredWithTheWayToTheOneBefore() {
    look();
    planner.plan(request(START, 2.6, PART));
    Route route = planner.plan(request(START, 6.9, Integer.MAX_VALUE));

    Route.Point end = route.points().get(route.points().size() - 1);
    assertThat(Math.hypot(end.northM() - 6.9, end.eastM() - 5.0)).isLessThan(0.2);
  }

  @Test
  void plan_otherHeadingAtTheGoal_isNotAnsweredWithTheWayToTheOneBefore() {
    look();
    planner.plan(request(START, 6.0, 1));
    RouteRequest other =
        new RouteRequest(
            START,
            6.0,
            5.0,
            OptionalDouble.of(Math.PI),
            0.2,
            TRUCK,
            costs,
            List.of(),
            List.of(),
            Integer.MAX_VALUE);

    assertThat(planner.plan(other)).isEqualTo(new HybridRoutes().plan(other));
  }

  @Test
  void plan_otherWindowOfCosts_isSearchedAnew() {
    look();
    planner.plan(request(START, 2.6, PART));
    CostGrid before = costs;
    gate = true;
    costs = grid();
    look();

    assertThat(planner.plan(request(START, 2.6, Integer.MAX_VALUE)).obstacle())
        .isEqualTo(Entrances.NO_WAY);
    assertThat(costs).isNotSameAs(before);
  }

  @Test
  void plan_answered_nextSearchBeginsAnew() {
    look();
    Route first = planner.plan(request(START, 2.6, Integer.MAX_VALUE));
    gate = true;
    look();

    assertThat(first.exists()).isTrue();
    assertThat(planner.plan(request(START, 2.6, Integer.MAX_VALUE)).exists()).isFalse();
  }

  @Test
  void plan_mouthCloses_saysThatObstaclesLeaveNoWay() {
    gate = true;
    look();

    assertThat(planner.plan(request(START, 2.6, Integer.MAX_VALUE)).obstacle())
        .isEqualTo(Entrances.NO_WAY);
  }

  @Test
  void plan_mouthClosesWhileItIsSought_noWayLeadsThroughIt() {
    look();
    planner.plan(request(START, 2.6, PART));
    gate = true;
    look();

    Route route = askUntilAnswered(START);
    assertThat(route.exists()).isFalse();
  }

  /** A barrel with a radius of 0.3 m, 5 m ahead of the truck, as goal. */
  private Route toBarrel(double toleranceM) {
    GridFrame frame = costs.frame();
    costs.update(
        i -> Math.hypot(frame.centreNorthM(i) - 7.0, frame.centreEastM(i) - 8.0) < 0.3, i -> false);
    Route route = Route.sought();
    for (int asked = 0; route.goesOn() && asked < 1000; asked++) {
      route =
          planner.plan(
              new RouteRequest(
                  new Pose(7.0, 3.0, Math.PI / 2.0),
                  7.0,
                  8.0,
                  OptionalDouble.empty(),
                  toleranceM,
                  TRUCK,
                  costs,
                  List.of(),
                  List.of(),
                  PART));
    }
    return route;
  }

  private static double endM(Route route) {
    Route.Point end = route.points().get(route.points().size() - 1);
    return Math.hypot(end.northM() - 7.0, end.eastM() - 8.0);
  }

  @Test
  void plan_goalIsAnObstacle_endsWithinTheTolerance() {
    assertThat(endM(toBarrel(2.0))).isBetween(1.0, 1.4);
  }

  @Test
  void plan_goalIsAnObstacleAndLittleToleranceIsLeft_usesAllOfIt() {
    assertThat(endM(toBarrel(0.85))).isBetween(0.595, 0.82);
  }

  @Test
  void plan_goalIsAnObstacleWiderThanTheTolerance_hasNoWay() {
    assertThat(toBarrel(0.4).exists()).isFalse();
  }
}
