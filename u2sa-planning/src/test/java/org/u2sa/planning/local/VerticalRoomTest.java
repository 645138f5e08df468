package org.u2sa.planning.local;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import java.util.function.DoubleBinaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.route.Route;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.search.GridFrame;
import org.u2sa.planning.search.Inflation;
import org.u2sa.planning.seen.Mover;
import org.u2sa.planning.seen.PlanarShape;
import org.u2sa.service.motion.Drift;

/** A vehicle 50 m high in a lane too narrow to turn in, which a sphere enters from the front. */
class VerticalRoomTest {
  private static final double CELL = 1.0;
  private static final int SIZE = 600;
  private static final BodyDiscs BODY = new BodyDiscs(1.0, 1.0, 2.0);
  private static final Pose ORIGIN = new Pose(0.0, 0.0, 0.0);
  private static final double LANE = 5.0; // to each side
  private static final double HERE = -50.0;
  private static final double RADIUS = 15.0;
  private static final double CLEARANCE = 5.0;
  private static final double HORIZON_S = 20.0;
  private static final DoubleBinaryOperator UNKNOWN = (north, east) -> Double.NaN;

  private final CostGrid costs =
      new CostGrid(new GridFrame(-300.0, -300.0, CELL, SIZE, SIZE), new Inflation(3.0, 5.0, 3.0));

  VerticalRoomTest() {
    GridFrame frame = costs.frame();
    costs.update(i -> Math.abs(frame.centreEastM(i)) > LANE, i -> false);
  }

  private static MotionLimits limits(boolean stops) {
    return new MotionLimits(
        10.0,
        2.0,
        2.0,
        stops ? 0.0 : 30.0,
        stops,
        0.0,
        20.0,
        0.5,
        0.0,
        3.0,
        HORIZON_S,
        0.5,
        0.8,
        0.0);
  }

  /** Head-on and faster, at the vehicle's altitude or that much above. */
  private static Mover oncoming(double aboveM) {
    return new Mover(
        "T",
        0L,
        0.0,
        new double[] {250.0},
        new double[] {0.0},
        -15.0,
        0.0,
        RADIUS,
        0.0,
        0.0,
        new Mover.Heights(new double[] {HERE - aboveM}, 0.0, RADIUS));
  }

  private static VerticalRoom room(
      double topDownM, double bottomDownM, DoubleBinaryOperator ground, PlanarShape... elsewhere) {
    return new VerticalRoom(
        HERE,
        HERE,
        3.0,
        CLEARANCE,
        CLEARANCE,
        CLEARANCE,
        3.0,
        topDownM,
        bottomDownM,
        List.of(elsewhere),
        ground,
        0);
  }

  private ArcChoice along(boolean stops, Mover mover, VerticalRoom room) {
    Route.Point from = new Route.Point(0.0, 0.0, false);
    Route.Point to = new Route.Point(280.0, 0.0, false);
    return new ArcChooser(
            costs,
            BODY,
            List.of(mover),
            limits(stops),
            ORIGIN,
            10.0,
            0L,
            Optional.empty(),
            Optional.ofNullable(room),
            Drift.NONE)
        .along(new RouteTrack(Route.of(List.of(from, to), 280.0)));
  }

  @Test
  void along_noCourseKeepsTheDistance_climbsOnItsRoute() {
    ArcChoice choice = along(false, oncoming(0.0), room(-200.0, -10.0, UNKNOWN));

    assertThat(choice.kind()).isEqualTo(ArcChoice.Kind.EVADE);
    assertThat(choice.toDownM()).isCloseTo(HERE - 3.0 * HORIZON_S, within(1e-9));
    assertThat(choice.eastM()).isCloseTo(0.0, within(1e-9));
    assertThat(choice.northM()).isPositive();
  }

  @Test
  void along_levelOnly_saysThatNothingKeepsTheDistance() {
    ArcChoice choice = along(false, oncoming(0.0), null);

    assertThat(choice.kind()).isEqualTo(ArcChoice.Kind.BRAKE);
    assertThat(choice.toDownM()).isNaN();
  }

  @Test
  void along_trafficHigher_descends() {
    ArcChoice choice = along(false, oncoming(10.0), room(-75.0, -10.0, UNKNOWN));

    assertThat(choice.toDownM()).isGreaterThan(HERE);
  }

  @Test
  void along_ceilingTooLow_descendsToTheFloorAtMost() {
    ArcChoice choice = along(false, oncoming(0.0), room(-60.0, -20.0, UNKNOWN));

    assertThat(choice.kind()).isEqualTo(ArcChoice.Kind.EVADE);
    assertThat(choice.toDownM()).isCloseTo(-20.0, within(1e-9));
  }

  @Test
  void along_ceilingTooLowAndFloorUnknown_saysThatNothingKeepsTheDistance() {
    VerticalRoom room = room(-60.0, Double.POSITIVE_INFINITY, UNKNOWN);

    assertThat(along(false, oncoming(0.0), room).kind()).isEqualTo(ArcChoice.Kind.BRAKE);
  }

  @Test
  void along_ceilingTooLowAndGroundKnown_descendsUnlessAHillIsAhead() {
    VerticalRoom plain = room(-60.0, -5.0, (north, east) -> 0.0);
    VerticalRoom hill = room(-60.0, -5.0, (north, east) -> north > 40.0 ? -40.0 : 0.0);

    assertThat(along(false, oncoming(0.0), plain).toDownM()).isGreaterThan(HERE);
    assertThat(along(false, oncoming(0.0), hill).kind()).isEqualTo(ArcChoice.Kind.BRAKE);
  }

  @Test
  void along_obstacleBelow_doesNotDescendIntoIt() {
    PlanarShape tower =
        new PlanarShape(
            "tower",
            PlanarShape.Kind.POINTS,
            new double[] {60.0},
            new double[] {0.0},
            10.0,
            -40.0,
            0.0);

    ArcChoice free = along(false, oncoming(0.0), room(-60.0, -10.0, UNKNOWN));
    ArcChoice blocked = along(false, oncoming(0.0), room(-60.0, -10.0, UNKNOWN, tower));

    assertThat(free.toDownM()).isGreaterThan(HERE);
    assertThat(blocked.kind()).isEqualTo(ArcChoice.Kind.BRAKE);
  }

  @Test
  void along_trafficFarEnoughAbove_follows() {
    ArcChoice level = along(false, oncoming(RADIUS + CLEARANCE + 1.0), null);
    ArcChoice choice =
        along(false, oncoming(RADIUS + CLEARANCE + 1.0), room(-200.0, -10.0, UNKNOWN));

    assertThat(level.kind()).isEqualTo(ArcChoice.Kind.BRAKE);
    assertThat(choice.kind()).isEqualTo(ArcChoice.Kind.FOLLOW);
  }

  @Test
  void along_hexacopterInTheLane_climbs() {
    ArcChoice level = along(true, oncoming(0.0), null);
    ArcChoice choice = along(true, oncoming(0.0), room(-200.0, -10.0, UNKNOWN));

    assertThat(level.toDownM()).isNaN();
    assertThat(choice.kind()).isEqualTo(ArcChoice.Kind.EVADE);
    assertThat(choice.toDownM()).isLessThan(HERE - 20.0);
  }

  /** An aircraft of the same speed flies beside it, somewhat behind, between it and its goal. */
  @Test
  void along_trafficOfTheSameSpeedBeside_climbsOnTheCourseThatAvoidsIt() {
    costs.update(i -> false, i -> false);
    Mover beside =
        new Mover(
            "T",
            0L,
            0.0,
            new double[] {-15.0},
            new double[] {35.0},
            10.0,
            0.0,
            RADIUS,
            0.0,
            0.0,
            new Mover.Heights(new double[] {HERE}, 0.0, RADIUS));
    Route.Point from = new Route.Point(0.0, 0.0, false);
    Route.Point to = new Route.Point(20.0, 250.0, false);
    RouteTrack right = new RouteTrack(Route.of(List.of(from, to), 250.0));

    ArcChoice choice =
        new ArcChooser(
                costs,
                BODY,
                List.of(beside),
                limits(false),
                ORIGIN,
                10.0,
                0L,
                Optional.empty(),
                Optional.of(room(-200.0, -10.0, UNKNOWN)),
                Drift.NONE)
            .along(right);

    assertThat(choice.kind()).isEqualTo(ArcChoice.Kind.EVADE);
    assertThat(Math.atan2(choice.eastM(), choice.northM())).isLessThan(0.5);
    assertThat(choice.toDownM()).isLessThan(HERE);
  }

  /** An aircraft begins to move along its route while it still turns. */
  @ParameterizedTest
  @CsvSource({"-20, false", "20, true"})
  void along_routeBehindIt_turnsOnlyIfTrafficLeavesItFree(double trafficNorthM, boolean turns) {
    costs.update(i -> false, i -> false);
    Mover.Heights below = new Mover.Heights(new double[] {HERE + 10.0}, 0.0, RADIUS);
    double[] north = {trafficNorthM};
    Mover hovers = new Mover("T", 0L, 0.0, north, new double[1], 0, 0, RADIUS, 0, 0, below);
    ArcChooser arcs =
        new ArcChooser(
            costs,
            BODY,
            List.of(hovers),
            limits(true),
            ORIGIN,
            0.0,
            0L,
            Optional.empty(),
            Optional.of(room(HERE, HERE, UNKNOWN)),
            Drift.NONE);
    Route.Point from = new Route.Point(0.0, 0.0, false);
    Route.Point to = new Route.Point(-280.0, 0.0, false);
    ArcChoice choice = arcs.along(new RouteTrack(Route.of(List.of(from, to), 280.0)));

    assertThat(choice.kind() == ArcChoice.Kind.FOLLOW).isEqualTo(turns);
  }

  /** Level ground 20 m below, which rises to the right at a slope of 2:1. */
  private static VerticalRoom slope(double levelM) {
    return new VerticalRoom(
        HERE,
        HERE,
        3.0,
        CLEARANCE,
        CLEARANCE,
        levelM,
        3.0,
        -200.0,
        -10.0,
        List.of(),
        (north, east) -> HERE + 20.0 - 2.0 * Math.max(0.0, east),
        0);
  }

  private double freeM(boolean stops, Motion motion, VerticalRoom room) {
    costs.update(i -> false, i -> false);
    MotionLimits limits = limits(stops);
    TrafficForecast none = new TrafficForecast(List.of(), BODY, limits, ORIGIN, 0L, room);
    return new MotionForecast(costs, BODY, none, room, limits, ORIGIN, 5.0).play(motion).freeM();
  }

  /** The ground is 5 m below 7.5 m to the right, 2 m below 9 m to the right. */
  @ParameterizedTest
  @CsvSource({"true, 5, 17.9", "true, 2, 19.8", "false, 5, 17.9", "false, 2, 19.8"})
  void play_levelArcToASlope_isFreeUpToIt(boolean stops, double levelM, double freeM) {
    Motion right = Motion.arc(0.05, false, 5.0, 25.0);
    Motion left = Motion.arc(-0.05, false, 5.0, 25.0);

    assertThat(freeM(stops, right, slope(levelM))).isCloseTo(freeM, within(1.0));
    assertThat(freeM(stops, left, slope(levelM))).isInfinite();
  }

  /** An aeroplane is led by its mission; a multirotor can stop. */
  @Test
  void play_routeToASlope_isFreeUpToItForAVehicleThatStops() {
    Route.Point from = new Route.Point(0.0, 0.0, false);
    Route.Point to = new Route.Point(100.0, 100.0, false);
    RouteTrack track = new RouteTrack(Route.of(List.of(from, to), 142.0));

    Motion along = Motion.along(track, 0.05, false, 5.0, 25.0);

    assertThat(freeM(true, along, slope(CLEARANCE))).isBetween(1.0, 100.0);
    assertThat(freeM(false, along, slope(CLEARANCE))).isInfinite();
  }

  /** An aeroplane can only pass a wall where the ground rises. */
  @Test
  void along_slopeOnTheOnlyFreeSide_doesNotTurnIntoIt() {
    GridFrame frame = costs.frame();
    costs.update(i -> frame.centreNorthM(i) > 30.0 && frame.centreEastM(i) < 5.0, i -> false);
    Route.Point from = new Route.Point(0.0, 0.0, false);
    Route.Point to = new Route.Point(280.0, 0.0, false);
    ArcChooser arcs =
        new ArcChooser(
            costs,
            BODY,
            List.of(),
            limits(false),
            ORIGIN,
            10.0,
            0L,
            Optional.empty(),
            Optional.of(slope(CLEARANCE)),
            Drift.NONE);

    assertThat(arcs.along(new RouteTrack(Route.of(List.of(from, to), 280.0))).eastM())
        .isLessThan(7.5);
  }

  @Test
  void isGroundNear_groundUnknown_isFalse() {
    assertThat(room(-200.0, -10.0, UNKNOWN).isGroundNear(ORIGIN, HERE + 40.0)).isFalse();
  }

  @Test
  void onWayM_descentToItsGoal_endsAtTheLowestAltitudeThere() {
    VerticalRoom room =
        goalAt(HERE + 30.0).descendingTo((north, east) -> HERE + (north > 50.0 ? 10.0 : -5.0));
    Pose beyond = new Pose(100.0, 0.0, 0.0);

    assertThat(room.onWayM(beyond, 2.0)).isEqualTo(HERE + 6.0);
    assertThat(room.onWayM(beyond, 9.0)).isEqualTo(HERE + 10.0);
    assertThat(room.onWayM(ORIGIN, 9.0)).isEqualTo(HERE); // it need not climb at once
    assertThat(goalAt(HERE + 30.0).onWayM(ORIGIN, 9.0)).isEqualTo(HERE + 27.0);
  }

  private static VerticalRoom goalAt(double downM) {
    return new VerticalRoom(
        HERE,
        downM,
        3.0,
        CLEARANCE,
        CLEARANCE,
        CLEARANCE,
        3.0,
        Double.NEGATIVE_INFINITY,
        Double.POSITIVE_INFINITY,
        List.of(),
        UNKNOWN,
        0);
  }
}
