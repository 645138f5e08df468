package org.u2sa.report.score;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class RunScorerTest {

  private static RunScore score(List<TrackSample> track) {
    return RunScorer.score(SyntheticFlight.twoWaypoints(), track, RunOutcome.clean());
  }

  @Test
  void score_flightAlongTheLine_meetsBothWaypoints() {
    RunScore score = score(SyntheticFlight.northward(0.0, 0.0));
    assertThat(score.captured()).isEqualTo(2);
    assertThat(score.success()).isTrue();
    assertThat(score.crossTrackRmsM().getAsDouble()).isLessThan(0.001);
    assertThat(score.flight().orElseThrow().altitudeRmsM().getAsDouble()).isLessThan(1e-9);
    WaypointResult first = score.waypoints().get(0);
    assertThat(first.missM().getAsDouble()).isLessThan(0.001);
    assertThat(first.timeS().getAsDouble()).isCloseTo(40.0, within(1e-3));
  }

  @Test
  void score_flight20MetresBeside_has20MetresOfCrossTrackAndMiss() {
    RunScore score = score(SyntheticFlight.northward(20.0, 0.0));
    assertThat(score.crossTrackRmsM().getAsDouble()).isCloseTo(20.0, within(0.01));
    assertThat(score.crossTrackRmsWholeLegsM().getAsDouble()).isCloseTo(20.0, within(0.01));
    assertThat(score.waypoints())
        .allSatisfy(w -> assertThat(w.missM().getAsDouble()).isCloseTo(20.0, within(0.01)));
  }

  @Test
  void score_sparseSamples_interpolatesTheNearestPoint() {
    List<TrackSample> track =
        List.of(
            SyntheticFlight.sample(0.0, 30.0, 1000.0, 480.0, 0),
            SyntheticFlight.sample(40.0, 30.0, 3000.0, 520.0, 1),
            SyntheticFlight.sample(41.0, 30.0, 3050.0, 520.0, 1));
    WaypointResult first = score(track).waypoints().get(0);
    assertThat(first.missM().getAsDouble()).isCloseTo(30.0, within(0.01));
    assertThat(first.altitudeErrorM().getAsDouble()).isCloseTo(0.0, within(0.01));
    assertThat(first.timeS().getAsDouble()).isCloseTo(20.0, within(0.01));
  }

  @Test
  void score_turnOntoTheLeg_isLeftOutOfStraightsOnly() {
    List<TrackSample> track = new ArrayList<>();
    for (TrackSample s : SyntheticFlight.northward(0.0, 0.0)) {
      double north = s.timeS() * 50.0;
      double east = s.leg() == 1 && north < 2900.0 ? 200.0 : 10.0;
      track.add(SyntheticFlight.sample(s.timeS(), east, north, 500.0, s.leg()));
    }
    RunScore score = score(track);
    assertThat(score.crossTrackRmsM().getAsDouble()).isCloseTo(10.0, within(0.01));
    assertThat(score.crossTrackRmsWholeLegsM().getAsDouble()).isBetween(90.0, 110.0);
  }

  @Test
  void score_flightTooHigh_tellsAltitudeErrors() {
    RunScore score = score(SyntheticFlight.northward(0.0, 12.0));
    assertThat(score.flight().orElseThrow().altitudeRmsM().getAsDouble())
        .isCloseTo(12.0, within(1e-9));
    assertThat(score.flight().orElseThrow().altitudeMaxErrorM().getAsDouble())
        .isCloseTo(12.0, within(1e-9));
    assertThat(score.waypoints().get(1).altitudeErrorM().getAsDouble())
        .isCloseTo(12.0, within(1e-9));
  }

  @Test
  void score_legAfterAGoalWithoutAPlace_hasNoCrossTrack() {
    List<TrackSample> track = new ArrayList<>();
    for (TrackSample s : SyntheticFlight.northward(20.0, 0.0)) {
      boolean detour = s.leg() == 1 && s.timeS() < 60.0;
      track.add(
          SyntheticFlight.sample(s.timeS(), 20.0, s.timeS() * 50.0, 500.0, detour ? -1 : s.leg()));
    }
    RunScore score = score(track);
    assertThat(score.captured()).isEqualTo(2);
    assertThat(score.crossTrackRmsM()).isEmpty();
    assertThat(score.crossTrackRmsWholeLegsM()).isEmpty();
  }

  @Test
  void score_beyondTheCaptureRadius_isNotCaptured() {
    assertThat(score(SyntheticFlight.northward(99.0, 0.0)).captured()).isEqualTo(2);
    assertThat(score(SyntheticFlight.northward(101.0, 0.0)).captured()).isZero();
  }

  @Test
  void score_beyondTheVerticalThreshold_isNotCaptured() {
    assertThat(score(SyntheticFlight.northward(0.0, 49.0)).captured()).isEqualTo(2);
    assertThat(score(SyntheticFlight.northward(0.0, 51.0)).captured()).isZero();
    assertThat(score(SyntheticFlight.northward(0.0, -51.0)).captured()).isZero();
  }

  @Test
  void score_climbThroughTheThresholdWithinTheCircle_isCaptured() {
    List<TrackSample> track =
        List.of(
            SyntheticFlight.sample(
                0.0, 0.0, 1000.0, 300.0,
                0), // 445 m over the waypoint, 455 m when leaving the circle
            SyntheticFlight.sample(40.0, 0.0, 3000.0, 590.0, 1));
    assertThat(score(track).waypoints().get(0).captured()).isTrue();
    List<TrackSample> lower =
        List.of(
            SyntheticFlight.sample(0.0, 0.0, 1000.0, 270.0, 0),
            SyntheticFlight.sample(40.0, 0.0, 3000.0, 590.0, 1));
    assertThat(score(lower).waypoints().get(0).captured()).isFalse();
  }

  @Test
  void score_waypointNeverTargeted_hasNoNumbers() {
    RunScore score = score(SyntheticFlight.northward(0.0, 0.0).subList(0, 300));
    WaypointResult second = score.waypoints().get(1);
    assertThat(second.missM()).isEmpty();
    assertThat(second.captured()).isFalse();
    assertThat(score.crossTrackRmsM()).isEmpty();
    assertThat(score.success()).isFalse();
  }

  @Test
  void score_straightUpThroughTheWaypoint_isCapturedOnTheWay() {
    RunPlan.Waypoint waypoint =
        new RunPlan.Waypoint(
            "floor", 10.0, 54.0, OptionalDouble.of(500.0), 1.0, OptionalDouble.of(1.0));
    List<TrackSample> elevator =
        List.of(
            new TrackSample(
                0.0, 10.0, 54.0, 480.0, 0, 0, OptionalDouble.empty(), 0, "UP", Optional.empty()),
            new TrackSample(
                10.0, 10.0, 54.0, 490.0, 0, 0, OptionalDouble.empty(), 0, "UP", Optional.empty()),
            new TrackSample(
                20.0, 10.0, 54.0, 510.0, 0, 0, OptionalDouble.empty(), 0, "UP", Optional.empty()));

    WaypointResult result =
        RunScorer.score(
                new RunPlan(Domain.GROUND, Optional.empty(), List.of(waypoint)),
                elevator,
                RunOutcome.clean())
            .waypoints()
            .get(0);

    assertThat(result.captured()).isTrue();
    assertThat(result.altitudeErrorM().orElseThrow()).isCloseTo(0.0, within(1e-9));
    assertThat(result.timeS().orElseThrow()).isCloseTo(15.0, within(1e-9));
  }

  @Test
  void score_acrossTheDateLine_measuresTheShortWay() {
    RunPlan.Waypoint waypoint =
        new RunPlan.Waypoint(
            "date line", 179.9999, 0.0, OptionalDouble.empty(), 100.0, OptionalDouble.empty());
    TrackSample sample =
        new TrackSample(
            0.0,
            -179.9999,
            0.0,
            500.0,
            0,
            50,
            OptionalDouble.empty(),
            0,
            "CRUISE",
            Optional.of(new TrackSample.Flight(0, 0, 50, false)));
    WaypointResult result =
        RunScorer.score(
                new RunPlan(Domain.AIR, Optional.empty(), List.of(waypoint)),
                List.of(sample),
                RunOutcome.clean())
            .waypoints()
            .get(0);
    assertThat(result.missM().getAsDouble())
        .isCloseTo(22.26, within(0.01)); // 0.0002° of the equator
    assertThat(result.altitudeErrorM()).isEmpty();
  }

  @Test
  void score_takeOff_countsFromScreenHeightOn() {
    RunPlan.Start home =
        new RunPlan.Start(SyntheticFlight.LONGITUDE, SyntheticFlight.LATITUDE, 100.0, 0.0);
    RunPlan plan =
        new RunPlan(Domain.AIR, Optional.of(home), SyntheticFlight.twoWaypoints().waypoints());
    TrackSample roll =
        new TrackSample(
            0.0,
            -157.9,
            21.3,
            100.0,
            0,
            5.0,
            OptionalDouble.empty(),
            0,
            "ROLL",
            Optional.of(new TrackSample.Flight(0.9, 0, 5.0, true)));
    TrackSample low =
        new TrackSample(
            1.0,
            -157.9,
            21.3,
            110.0,
            0,
            30.0,
            OptionalDouble.empty(),
            0,
            "CLIMB",
            Optional.of(new TrackSample.Flight(0.8, 0, 30.0, false)));
    TrackSample high =
        new TrackSample(
            2.0,
            -157.9,
            21.3,
            116.0,
            0,
            35.0,
            OptionalDouble.empty(),
            0,
            "CLIMB",
            Optional.of(new TrackSample.Flight(-0.3, 0, 35.0, false)));
    RunScore before = RunScorer.score(plan, List.of(roll, low), RunOutcome.clean());
    assertThat(before.flight().orElseThrow().tookOff()).isFalse();
    assertThat(before.flight().orElseThrow().maxBankRad()).isEmpty();
    RunScore after = RunScorer.score(plan, List.of(roll, low, high), RunOutcome.clean());
    assertThat(after.flight().orElseThrow().tookOff()).isTrue();
    assertThat(after.flight().orElseThrow().maxBankRad().getAsDouble()).isEqualTo(0.3);
    assertThat(after.flight().orElseThrow().minAirspeedMps().getAsDouble()).isEqualTo(35.0);
  }

  static Stream<RunOutcome> unclean() {
    return Stream.of(
        new RunOutcome(1, false, List.of()),
        new RunOutcome(0, true, List.of()),
        new RunOutcome(0, false, List.of("left the fence at 12.0 s")));
  }

  @ParameterizedTest
  @MethodSource("unclean")
  void success_contactStallOrViolation_isNone(RunOutcome outcome) {
    RunScore score =
        RunScorer.score(SyntheticFlight.twoWaypoints(), SyntheticFlight.northward(0, 0), outcome);
    assertThat(score.captured()).isEqualTo(2);
    assertThat(score.success()).isFalse();
  }

  @Test
  void success_allCapturedAndClean_isOne() {
    RunScore score =
        RunScorer.score(
            SyntheticFlight.twoWaypoints(), SyntheticFlight.northward(0, 0), RunOutcome.clean());
    assertThat(score.success()).isTrue();
  }
}
