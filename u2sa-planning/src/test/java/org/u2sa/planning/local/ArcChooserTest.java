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
import org.u2sa.planning.seen.Mover;
import org.u2sa.service.motion.Drift;

/** A vehicle at the origin, pointing north, with a route ten metres straight ahead. */
class ArcChooserTest {
  private static final double CELL = 0.1;
  private static final int SIZE = 240;
  private static final BodyDiscs BODY = new BodyDiscs(0.3, 0.3, 0.5);
  private static final Pose ORIGIN = new Pose(0.0, 0.0, 0.0);

  private final CostGrid costs =
      new CostGrid(new GridFrame(-12.0, -12.0, CELL, SIZE, SIZE), new Inflation(0.5, 1.0, 3.0));

  private static MotionLimits rover() {
    return new MotionLimits(1.0, 0.8, 1.0, 0.0, true, 1.0, 1.0, 0.05, 0.0, 0.3, 4.0, 0.3, 0.8, 0.0);
  }

  /** The same, which keeps its distance where its route does. */
  private static MotionLimits careful() {
    return new MotionLimits(1.0, 0.8, 1.0, 0.0, true, 1.0, 1.0, 0.05, 0.3, 0.3, 4.0, 0.3, 0.8, 0.0);
  }

  private static MotionLimits aeroplane() {
    return new MotionLimits(
        1.0, 0.8, 1.0, 2.0, false, 0.0, 2.0, 0.05, 0.0, 0.3, 4.0, 0.3, 0.8, 0.0);
  }

  /** Fills what lies between these, ends included [m]. */
  private void wall(double south, double north, double west, double east) {
    GridFrame frame = costs.frame();
    costs.update(
        i ->
            costs.isOccupied(i)
                || (frame.centreNorthM(i) >= south
                    && frame.centreNorthM(i) <= north
                    && frame.centreEastM(i) >= west
                    && frame.centreEastM(i) <= east),
        i -> false);
  }

  private static Mover mover(double north, double east, double northMps, double eastMps) {
    return new Mover(
        "T", 0L, 0.0, new double[] {north}, new double[] {east}, northMps, eastMps, 0.3);
  }

  private ArcChooser arcs(MotionLimits limits, double speedMps, Mover... movers) {
    return arcs(limits, speedMps, Optional.empty(), movers);
  }

  private ArcChooser arcs(
      MotionLimits limits, double speedMps, Optional<ArcChoice> before, Mover... movers) {
    return arcs(BODY, limits, speedMps, before, movers);
  }

  private ArcChooser arcs(
      BodyDiscs body,
      MotionLimits limits,
      double speedMps,
      Optional<ArcChoice> before,
      Mover... movers) {
    return new ArcChooser(
        costs,
        body,
        List.of(movers),
        limits,
        ORIGIN,
        speedMps,
        0L,
        before,
        Optional.empty(),
        Drift.NONE);
  }

  private static RouteTrack north() {
    return track(10.0, 0.0, false);
  }

  private static RouteTrack track(double northM, double eastM, boolean backwards) {
    Route.Point from = new Route.Point(0.0, 0.0, backwards);
    Route.Point to = new Route.Point(northM, eastM, backwards);
    return new RouteTrack(Route.of(List.of(from, to), 10.0));
  }

  @Test
  void along_nothingInTheWay_followsAtFullSpeed() {
    ArcChoice choice = arcs(rover(), 1.0).along(north());

    assertThat(choice.kind()).isEqualTo(ArcChoice.Kind.FOLLOW);
    assertThat(choice.northM()).isCloseTo(1.0, within(1e-9));
    assertThat(choice.eastM()).isCloseTo(0.0, within(1e-9));
    assertThat(choice.speedMps()).isEqualTo(1.0);
  }

  @Test
  void lookTo_roomToTurn_turnsThereOnTheSpot() {
    ArcChoice choice = arcs(rover(), 0.0).lookTo(Math.toRadians(60.0));

    assertThat(Math.atan2(choice.eastM(), choice.northM()))
        .isCloseTo(Math.toRadians(60.0), within(1e-9));
    assertThat(choice.speedMps()).isPositive();
  }

  @Test
  void lookTo_looksThereAlready_stands() {
    assertThat(arcs(rover(), 0.0).lookTo(Math.toRadians(11.0)).speedMps()).isZero();
  }

  @Test
  void lookTo_wallBeside_backsOutFirst() {
    wall(-0.2, 2.0, 0.35, 0.6);
    ArcChoice choice = arcs(rover(), 0.0).lookTo(Math.toRadians(60.0));

    assertThat(choice.backwards()).isTrue();
    assertThat(choice.northM()).isNegative();
  }

  /**
   * It would come to stand with its middle a few centimetres farther from a wall than its corners
   * reach.
   */
  @Test
  void along_turnBesideAWallAtSpeed_standsFirst() {
    wall(-1.0, 3.0, 0.5, 0.65);
    RouteTrack rear = track(-10.0, 0.0, false);

    ArcChoice rolling = arcs(rover(), 1.0).along(rear);
    ArcChoice still = arcs(rover(), 0.1).along(rear);

    assertThat(rolling.speedMps()).isZero();
    assertThat(rolling.kind()).isEqualTo(ArcChoice.Kind.EVADE);
    assertThat(still.kind()).isEqualTo(ArcChoice.Kind.FOLLOW);
    assertThat(still.northM()).isNegative();
  }

  /** It would otherwise stand as soon as it rolls, and set off again as soon as it stands. */
  @Test
  void along_noRoomToTurn_standsAndThenGoesOnUntilThereIs() {
    wall(-1.0, 8.0, 0.35, 0.5);
    RouteTrack rear = track(-10.0, 0.0, false);
    Mover behind = mover(-1.6, -0.4, 0.4, 0.0);

    assertThat(arcs(rover(), 0.3).along(rear).speedMps()).isZero();
    ArcChoice first = arcs(rover(), 0.1).along(rear);
    ArcChoice goesOn = makingRoom(-0.3).along(rear);
    ArcChoice leaves = makingRoom(0.3, behind).along(rear);

    assertThat(first.kind()).isEqualTo(ArcChoice.Kind.MAKE_ROOM);
    assertThat(first.backwards()).isTrue();
    assertThat(goesOn.kind()).isEqualTo(ArcChoice.Kind.MAKE_ROOM);
    assertThat(goesOn.speedMps()).isPositive();
    assertThat(leaves.speedMps()).isPositive();
    assertThat(leaves.northM()).isPositive();
  }

  private ArcChooser makingRoom(double speedMps, Mover... movers) {
    ArcChoice before = new ArcChoice(0.0, 0.0, 0.0, false, ArcChoice.Kind.MAKE_ROOM);
    return arcs(rover(), speedMps, Optional.of(before), movers);
  }

  /** Traffic comes from ahead, a little to one side, so that the other one is slightly better. */
  @ParameterizedTest
  @CsvSource({"0.01, -2", "0.01, 2", "-0.01, -2", "-0.01, 2"})
  void along_aircraftThatTurnsAlready_keepsTurningToThatSide(double eastM, double turnsM) {
    ArcChoice before = new ArcChoice(2.0, turnsM, 1.0, false, ArcChoice.Kind.EVADE);
    Mover traffic = mover(6.0, eastM, -1.0, 0.0);

    ArcChoice choice = arcs(aeroplane(), 1.0, Optional.of(before), traffic).along(north());

    assertThat(choice.kind()).isEqualTo(ArcChoice.Kind.EVADE);
    assertThat(choice.eastM() * turnsM).isPositive();
  }

  @Test
  void along_turnWithRoomAtSpeed_turnsAtOnce() {
    wall(-1.0, 3.0, 0.8, 0.9);
    ArcChoice rolling = arcs(rover(), 1.0).along(track(-10.0, 0.0, false));

    assertThat(rolling.kind()).isEqualTo(ArcChoice.Kind.FOLLOW);
    assertThat(rolling.northM()).isNegative();
  }

  @Test
  void lookTo_rollsBesideAWall_standsFirst() {
    wall(-1.0, 3.0, 0.5, 0.65);

    assertThat(arcs(rover(), 1.0).lookTo(Math.toRadians(60.0)).speedMps()).isZero();
    assertThat(arcs(rover(), 0.1).lookTo(Math.toRadians(60.0)).speedMps()).isPositive();
  }

  /** Numerically: a point that brakes evenly and turns evenly meanwhile. */
  @Test
  void slip_ofWhatTurnsWhileItBrakes_isHowFarAsideItComes() {
    MotionLimits limits =
        new MotionLimits(1.0, 0.8, 1.0, 0.0, true, 1.0, 1.0, 0.05, 0.0, 0.3, 4.0, 0.0, 0.8, 0.0);
    for (double mps = 0.2; mps < 1.5; mps += 0.1) {
      double aside = 0.0;
      double dt = 1.0e-3;
      for (double t = 0.0; t < mps / limits.brakingMps2(); t += dt) {
        aside += (mps - limits.brakingMps2() * t) * Math.sin(limits.turnRateRadPerS() * t) * dt;
      }
      assertThat(limits.slipM(mps)).isBetween(aside, 1.1 * aside);
      assertThat(rover().slipM(mps)).isGreaterThan(limits.slipM(mps)); // it takes time to react
    }
  }

  @Test
  void lookTo_vehicleThatCannotTurnOnTheSpot_goesOnAsWithoutRoute() {
    ArcChoice choice = arcs(aeroplane(), 1.0).lookTo(Math.toRadians(60.0));

    assertThat(choice).isEqualTo(arcs(aeroplane(), 1.0).withoutRoute());
  }

  @Test
  void along_wallAhead_isSlowEnoughToStopBeforeIt() {
    wall(1.3, 1.5, -3.0, 3.0);
    ArcChoice choice = arcs(rover(), 0.2).along(north());

    double discsAheadM = BODY.aheadM(BODY.count() - 1) + BODY.radiusM();
    assertThat(choice.speedMps()).isPositive();
    assertThat(rover().stoppingM(choice.speedMps())).isLessThan(1.3 - discsAheadM);
  }

  /** The route leads around the wall's end, an arc to a far point close to it. */
  @Test
  void along_routeAroundACorner_isFollowedCloselyAndMoreSlowlyIfDistanceIsPreferred() {
    wall(0.2, 0.6, 0.6, 1.5);
    RouteTrack around =
        new RouteTrack(
            Route.of(
                List.of(
                    new Route.Point(0.0, 0.0, false),
                    new Route.Point(0.7, 0.0, false),
                    new Route.Point(2.0, 1.3, false)),
                2.5));
    ArcChoice cuts = arcs(rover(), 0.5).along(around);
    ArcChoice keeps = arcs(careful(), 0.5).along(around);

    assertThat(cuts.eastM()).isGreaterThan(0.15);
    assertThat(keeps.kind()).isEqualTo(ArcChoice.Kind.FOLLOW);
    assertThat(keeps.eastM()).isLessThan(0.5 * cuts.eastM());
    assertThat(keeps.speedMps()).isBetween(0.3, 0.7);
  }

  @Test
  void along_narrowWayStraightOn_isFollowedAsFastHoweverMuchDistanceIsPreferred() {
    wall(-3.0, 5.0, 0.55, 0.7);
    wall(-3.0, 5.0, -0.7, -0.55);
    ArcChoice choice = arcs(careful(), 1.0).along(north());

    assertThat(choice.kind()).isEqualTo(ArcChoice.Kind.FOLLOW);
    assertThat(choice.northM()).isCloseTo(1.0, within(1e-9));
    assertThat(choice.speedMps()).isEqualTo(1.0);
  }

  @Test
  void along_routeToTheRear_isAPointToTurnTo() {
    ArcChoice choice = arcs(rover(), 0.0).along(track(-10.0, 1.0, false));

    assertThat(choice.kind()).isEqualTo(ArcChoice.Kind.FOLLOW);
    assertThat(choice.backwards()).isFalse();
    assertThat(choice.northM()).isNegative();
  }

  @Test
  void along_routeBackwards_goesBackwards() {
    ArcChoice choice = arcs(rover(), 0.0).along(track(-10.0, 0.0, true));

    assertThat(choice.backwards()).isTrue();
    assertThat(choice.northM()).isCloseTo(-1.0, within(1e-9));
  }

  /** Along a route, and out of a corner. */
  @ParameterizedTest
  @CsvSource({"1.0, 0.5", "0.3, 0.3", "0.2, 0.2"})
  void reverse_speedLimit_isKept(double backwardsMps, double outMps) {
    MotionLimits slow =
        new MotionLimits(
            1.0, 0.8, 1.0, 0.0, true, backwardsMps, 1.0, 0.05, 0.0, 0.3, 4.0, 0.3, 0.8, 0.0);
    ArcChoice followed = arcs(slow, 0.0).along(track(-10.0, 0.0, true));
    ArcChoice backsOut = arcs(slow, 0.0).backOut(2.0);

    assertThat(followed.speedMps()).isEqualTo(backwardsMps);
    assertThat(backsOut.backwards()).isTrue();
    assertThat(backsOut.speedMps()).isEqualTo(outMps);
  }

  @Test
  void along_trafficCrossesTheRoute_isNotFollowedIntoIt() {
    ArcChoice choice = arcs(rover(), 1.0, mover(2.0, -2.0, 0.0, 1.0)).along(north());

    assertThat(choice.kind()).isIn(ArcChoice.Kind.EVADE, ArcChoice.Kind.WAIT);
  }

  /** Ahead of traffic at full speed, but the wall straight ahead does not let it drive that. */
  @Test
  void along_slowerBesideAWallThanTrafficAllows_isNotFollowed() {
    Mover crossing = mover(-0.41, 3.78, 0.49, -0.87);
    assertThat(arcs(rover(), 1.0, crossing).along(track(3.0, 1.7, false)).kind())
        .isEqualTo(ArcChoice.Kind.FOLLOW);

    wall(1.0, 1.2, -3.0, 0.0);
    ArcChoice alone = arcs(rover(), 1.0).along(track(3.0, 1.7, false));
    assertThat(alone.kind()).isEqualTo(ArcChoice.Kind.FOLLOW);
    assertThat(alone.speedMps()).isBetween(0.4, 0.8);

    assertThat(arcs(rover(), 1.0, crossing).along(track(3.0, 1.7, false)).kind())
        .isNotEqualTo(ArcChoice.Kind.FOLLOW);
  }

  @Test
  void along_trafficFollowsBehindAndSlower_isIgnored() {
    ArcChoice choice = arcs(rover(), 1.0, mover(-2.0, 0.0, 0.5, 0.0)).along(north());

    assertThat(choice.kind()).isEqualTo(ArcChoice.Kind.FOLLOW);
    assertThat(choice.speedMps()).isEqualTo(1.0);
  }

  private MotionForecast forecast(MotionLimits limits, double speedMps, Mover mover) {
    TrafficForecast traffic = new TrafficForecast(List.of(mover), BODY, limits, ORIGIN, 0L, null);
    return new MotionForecast(costs, BODY, traffic, null, limits, ORIGIN, speedMps);
  }

  /** The wall ends the motion, and there the vehicle stands when traffic comes. */
  @Test
  void play_endsBeforeAWallThatTrafficPasses_meetsItAsItStands() {
    wall(1.3, 1.5, -3.0, 3.0);
    Mover passing = mover(0.8, -3.0, 0.0, 0.9);
    MotionForecast forecast = forecast(rover(), 0.0, passing);
    MotionForecast.Outcome outcome = forecast.play(Motion.arc(0.0, false, 1.0, 1.0));

    assertThat(outcome.freeM()).isBetween(0.4, 0.9);
    assertThat(outcome.meetsS()).isBetween(1.0, 4.0);
    assertThat(outcome.gapM()).isNegative();
  }

  /** A wall beyond its arc ends the motion too: it will not be behind it when traffic comes. */
  @Test
  void play_wallBeyondTheArcThatTrafficPasses_meetsItAsItStands() {
    wall(3.0, 3.2, -4.0, 4.0);
    Mover passing = mover(2.5, -4.0, 0.0, 1.0);
    MotionForecast forecast = forecast(rover(), 1.0, passing);
    MotionForecast.Outcome outcome = forecast.play(Motion.arc(0.0, false, 1.0, 1.0));

    assertThat(outcome.freeM()).isBetween(2.1, 2.6);
    assertThat(outcome.meetsS()).isBetween(2.0, 4.0);
    assertThat(outcome.gapM()).isNegative();
  }

  /** What cannot stand flies to its route, and meets what is between. */
  @Test
  void play_aeroplaneBesideItsRoute_meetsWhatIsOnTheWayBackToIt() {
    Route.Point from = new Route.Point(0.0, 6.0, false);
    Route.Point to = new Route.Point(10.0, 6.0, false);
    RouteTrack track = new RouteTrack(Route.of(List.of(from, to), 10.0));
    Mover between = mover(2.3, 1.2, 0.0, 0.0);
    MotionForecast forecast = forecast(aeroplane(), 1.0, between);
    MotionForecast.Outcome outcome = forecast.play(Motion.along(track, 0.0, false, 1.0, 0.5));

    assertThat(outcome.meetsS()).isBetween(1.0, 3.0);
    assertThat(outcome.gapM()).isLessThan(aeroplane().trafficM());
  }

  /** Its outer wheels turn no faster in an arc, so it does not get as far round. */
  @Test
  void play_arcOnTheRoute_isSlowerThanStraightOn() {
    double round = 3.9; // rad on the circle of 1 m radius, which full speed reaches in time
    Mover there = mover(Math.sin(round), 1.0 - Math.cos(round), 0.0, 0.0);
    MotionForecast forecast = forecast(rover(), 1.0, there);
    double tight = rover().tightest();

    double full = forecast.play(Motion.arc(tight, false, 1.0, 10.0)).gapM();
    double onRoute = forecast.play(Motion.along(north(), tight, false, 1.0, 10.0)).gapM();
    assertThat(full).isNegative();
    assertThat(onRoute).isGreaterThan(full + 0.1);
  }

  @Test
  void backOut_noWayFreeOfTraffic_leavesWhatComesRatherThanWait() {
    Mover[] around = { // from behind, and beside, so that no arc of the whole way is free of it
      mover(-1.4, 0.0, 0.5, 0.0), mover(2.6, 0.0, 0.0, 0.06)
    };
    ArcChoice choice = arcs(rover(), 0.0, around).backOut(1.2);

    assertThat(choice.kind()).isNotEqualTo(ArcChoice.Kind.WAIT);
    assertThat(choice.speedMps()).isPositive();
  }

  @Test
  void withoutRoute_nearerToTrafficThanIsToBeKept_leavesItRatherThanWait() {
    // a sphere of 2.3 m, of which 2 m are kept around a walker who comes from behind
    Mover kept = new Mover("T", 0L, 0.0, new double[] {-2.4}, new double[] {0.0}, 0.4, 0.0, 2.3);
    ArcChoice choice = arcs(rover(), 0.0, kept).withoutRoute();

    assertThat(choice.kind()).isNotEqualTo(ArcChoice.Kind.WAIT);
    assertThat(choice.speedMps()).isGreaterThan(0.3);
    assertThat(choice.northM()).isGreaterThan(0.0);
  }

  @Test
  void withoutRoute_trafficComesAtItInAGap_turnsOnTheSpotAndLeaves() {
    wall(0.7, 0.9, -4.0, 4.0);
    wall(-0.9, -0.7, -4.0, 4.0);
    ArcChoice choice = arcs(rover(), 0.0, mover(0.0, -2.5, 0.0, 0.5)).withoutRoute();

    assertThat(choice.kind()).isEqualTo(ArcChoice.Kind.EVADE);
    assertThat(choice.eastM()).isGreaterThan(0.3); // away from it, which no arc leads to
    assertThat(Math.abs(choice.northM())).isLessThan(0.3);
  }

  @Test
  void withoutRoute_noTraffic_waits() {
    ArcChoice choice = arcs(rover(), 0.0).withoutRoute();

    assertThat(choice.kind()).isEqualTo(ArcChoice.Kind.WAIT);
    assertThat(choice.speedMps()).isZero();
  }

  @Test
  void withoutRoute_cannotStand_keepsItsSpeed() {
    wall(4.0, 4.2, -1.0, 1.0);
    ArcChoice choice = arcs(aeroplane(), 1.0).withoutRoute();

    assertThat(choice.speedMps()).isEqualTo(1.0);
    assertThat(choice.kind()).isEqualTo(ArcChoice.Kind.EVADE);
  }

  @Test
  void backOut_freeBehind_goesStraightBack() {
    ArcChoice choice = arcs(rover(), 0.0).backOut(1.0);

    assertThat(choice.backwards()).isTrue();
    assertThat(choice.northM()).isCloseTo(-1.0, within(1e-9));
  }

  /** Declares what lies south of a coordinate as never seen [m]. */
  private void unseen(double south) {
    costs.update(costs::isOccupied, i -> costs.frame().centreNorthM(i) < south);
  }

  @Test
  void backOut_neverSeenBehind_goesForward() {
    unseen(0.0);
    ArcChoice choice = arcs(rover(), 0.0).backOut(1.0);

    assertThat(choice.backwards()).isFalse();
    assertThat(choice.northM()).isPositive();
  }

  @Test
  void backOut_neverSeenBehindAndWallAhead_backsSlowly() {
    wall(0.4, 0.5, -12.0, 12.0);
    unseen(0.0);
    ArcChoice choice = arcs(rover(), 0.0).backOut(1.0);

    assertThat(choice.backwards()).isTrue();
    assertThat(choice.speedMps()).isEqualTo(0.3);
  }

  @Test
  void backOut_itsOwnTrackBehind_backsOverIt() {
    unseen(0.0);
    for (double north = -2.0; north < 0.0; north += 0.05) {
      costs.passed().add(BODY, north, 0.0, 0.0);
    }
    ArcChoice choice = arcs(rover(), 0.0).backOut(1.0);

    assertThat(choice.backwards()).isTrue();
    assertThat(choice.northM()).isNegative();
  }

  @Test
  void along_routeBackOverUnseenGround_isSlow() {
    MotionLimits truck =
        new MotionLimits(1.0, 0.8, 1.0, 2.0, true, 1.0, 1.0, 0.05, 0.0, 0.3, 4.0, 0.3, 0.8, 0.0);
    RouteTrack back = track(-10.0, 0.0, true);
    double seen = arcs(truck, 0.0).along(back).speedMps();
    unseen(0.0);
    double never = arcs(truck, 0.0).along(back).speedMps();

    assertThat(seen).isEqualTo(1.0);
    assertThat(never).isEqualTo(0.3);
  }

  /** Somebody comes from ahead: it would back away from him if it had seen what is behind. */
  @Test
  void along_trafficAheadAndNeverSeenBehind_doesNotReverse() {
    wall(-5.0, 12.0, 0.6, 0.8);
    wall(-5.0, 12.0, -0.8, -0.6);
    Mover comes = mover(2.5, 0.0, -0.5, 0.0);
    boolean backs = arcs(rover(), 0.0, comes).along(north()).backwards();
    costs.update(costs::isOccupied, i -> costs.frame().centreNorthM(i) < 0.0);
    ArcChoice stays = arcs(rover(), 0.0, comes).along(north());

    assertThat(backs).isTrue();
    assertThat(stays.backwards()).isFalse();
    assertThat(stays.speedMps()).isZero();
  }

  @Test
  void backOut_wallBehind_goesForward() {
    wall(-0.7, -0.5, -3.0, 3.0);
    ArcChoice choice = arcs(rover(), 0.0).backOut(1.0);

    assertThat(choice.backwards()).isFalse();
    assertThat(choice.northM()).isGreaterThan(0.5);
  }

  /** Its rear corner is already across a wall that the map shows as one row of cells. */
  @Test
  void backOut_cornerInAWall_goesNoDeeper() {
    wall(-4.0, -0.15, 0.11, 0.19);
    BodyDiscs body = BodyDiscs.closely(0.3, 0.3, 0.5, 0.1);
    ArcChoice choice = arcs(body, rover(), 0.0, Optional.empty()).backOut(1.0);

    assertThat(choice.backwards()).isFalse();
    assertThat(choice.northM()).isPositive();
  }

  @Test
  void backOut_obstacleWithinItsStoppingDistance_backsMoreSlowly() {
    wall(-0.8, -0.7, -3.0, 3.0);
    wall(0.5, 0.6, -3.0, 3.0);
    ArcChoice choice = arcs(rover(), 0.0).backOut(0.6);

    assertThat(choice.backwards()).isTrue();
    assertThat(choice.speedMps()).isBetween(0.05, 0.4);
  }

  @Test
  void backOut_nearerToOneWallOfAPassage_steersToItsMiddle() {
    wall(-8.0, 8.0, 0.45, 0.6);
    wall(-8.0, 8.0, -0.8, -0.65);
    ArcChoice choice = arcs(rover(), 0.0).backOut(1.0);

    assertThat(choice.backwards()).isTrue();
    assertThat(choice.eastM()).isNegative();
  }

  /** Behind it, there is less room than ahead: it would otherwise go to and fro. */
  @Test
  void along_makingRoomInReverse_goesOnAlthoughTheWayAheadIsLonger() {
    wall(-0.9, 8.0, 0.35, 0.5);
    wall(-1.1, -1.0, -3.0, 3.0);
    ArcChoice before = new ArcChoice(-1.0, 0.0, 0.3, true, ArcChoice.Kind.MAKE_ROOM);

    ArcChoice choice = arcs(rover(), -0.1, Optional.of(before)).along(track(-10.0, 0.0, false));

    assertThat(choice.kind()).isEqualTo(ArcChoice.Kind.MAKE_ROOM);
    assertThat(choice.backwards()).isTrue();
  }

  /** A dock, open astern, in which it can turn but comes closer to the walls than routes do. */
  private void dock(double mouthM) {
    wall(mouthM, 2.0, 0.49, 0.56);
    wall(mouthM, 2.0, -0.56, -0.49);
    wall(0.5, 0.6, -0.5, 0.5);
  }

  private ArcChoice leaves(double clearanceM, double backwardsMps) {
    MotionLimits limits =
        new MotionLimits(
            1.0, 0.8, 1.0, 0.0, true, backwardsMps, 1.0, 0.05, 0.0, 0.3, 4.0, 0.3, 0.8, clearanceM);
    return arcs(limits, 0.0).along(track(-10.0, 0.5, false));
  }

  @Test
  void along_turnInADock_backsOutFirst() {
    dock(-2.0);

    ArcChoice choice = leaves(0.2, 1.0);
    assertThat(choice.kind()).isEqualTo(ArcChoice.Kind.MAKE_ROOM);
    assertThat(choice.backwards()).isTrue();
    assertThat(choice.northM()).isLessThan(-0.3);
    assertThat(choice.eastM()).isCloseTo(0.0, within(0.05));
    assertThat(choice.speedMps()).isPositive();
  }

  @Test
  void along_turnInADockWithRoomForTheClearance_turns() {
    dock(-2.0);

    assertThat(leaves(0.05, 1.0).kind()).isEqualTo(ArcChoice.Kind.FOLLOW);
  }

  @Test
  void along_turnInADockItCannotLeave_turns() {
    dock(-2.0);
    assertThat(leaves(0.2, 0.0).kind()).isEqualTo(ArcChoice.Kind.FOLLOW);

    wall(-1.1, -1.0, -0.5, 0.5);
    assertThat(leaves(0.2, 1.0).kind()).isEqualTo(ArcChoice.Kind.FOLLOW);
  }

  @Test
  void along_turnInADockAndNothingSeenAstern_turns() {
    dock(-2.0);
    unseen(-0.5);

    assertThat(leaves(0.2, 1.0).kind()).isEqualTo(ArcChoice.Kind.FOLLOW);
  }

  @Test
  void along_turnInAPassageOpenAhead_leavesItByTheShorterWay() {
    wall(-4.0, 0.6, 0.49, 0.56);
    wall(-4.0, 0.6, -0.56, -0.49);

    ArcChoice choice = leaves(0.2, 1.0);
    assertThat(choice.kind()).isEqualTo(ArcChoice.Kind.MAKE_ROOM);
    assertThat(choice.backwards()).isFalse();
    assertThat(choice.northM()).isPositive();
  }

  @Test
  void along_turnInADockAndSomebodyComesAstern_doesNotBackOut() {
    dock(-2.0);
    MotionLimits limits =
        new MotionLimits(1.0, 0.8, 1.0, 0.0, true, 1.0, 1.0, 0.05, 0.0, 0.3, 4.0, 0.3, 0.8, 0.2);
    ArcChoice choice =
        arcs(limits, 0.0, mover(-3.0, 0.0, 0.5, 0.0)).along(track(-10.0, 0.5, false));

    assertThat(choice.backwards()).isFalse();
  }

  @Test
  void along_turnBesideALongWall_bendsAwayFromItRatherThanBackAlongIt() {
    wall(-8.0, 8.0, 0.49, 0.56);

    ArcChoice choice = leaves(0.2, 1.0);
    assertThat(choice.kind()).isEqualTo(ArcChoice.Kind.MAKE_ROOM);
    assertThat(Math.abs(choice.northM())).isLessThan(1.5);
    assertThat(choice.eastM()).isLessThan(-0.03);
  }
}
