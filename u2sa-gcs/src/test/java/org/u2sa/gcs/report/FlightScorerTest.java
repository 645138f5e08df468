package org.u2sa.gcs.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;

class FlightScorerTest {

  private static FlightScore score(List<FlightSample> track) {
    return FlightScorer.score(SyntheticFlight.twoWaypoints(), track, FlightOutcome.clean());
  }

  @Test
  void score_flightAlongTheLine_meetsBothWaypoints() {
    FlightScore score = score(SyntheticFlight.northward(0.0, 0.0));
    assertThat(score.captured()).isEqualTo(2);
    assertThat(score.success()).isTrue();
    assertThat(score.crossTrackRmsM().getAsDouble()).isLessThan(0.001);
    assertThat(score.altitudeRmsM().getAsDouble()).isLessThan(1e-9);
    WaypointResult first = score.waypoints().get(0);
    assertThat(first.missM().getAsDouble()).isLessThan(0.001);
    assertThat(first.timeS().getAsDouble()).isCloseTo(40.0, within(1e-3));
  }

  @Test
  void score_flight20MetresBeside_has20MetresOfCrossTrackAndMiss() {
    FlightScore score = score(SyntheticFlight.northward(20.0, 0.0));
    assertThat(score.crossTrackRmsM().getAsDouble()).isCloseTo(20.0, within(0.01));
    assertThat(score.crossTrackRmsWholeLegsM().getAsDouble()).isCloseTo(20.0, within(0.01));
    assertThat(score.waypoints())
        .allSatisfy(w -> assertThat(w.missM().getAsDouble()).isCloseTo(20.0, within(0.01)));
  }

  @Test
  void score_sparseSamples_interpolatesTheNearestPoint() {
    List<FlightSample> track =
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
    List<FlightSample> track = new ArrayList<>();
    for (FlightSample s : SyntheticFlight.northward(0.0, 0.0)) {
      double north = s.timeS() * 50.0;
      double east = s.leg() == 1 && north < 2900.0 ? 200.0 : 10.0;
      track.add(SyntheticFlight.sample(s.timeS(), east, north, 500.0, s.leg()));
    }
    FlightScore score = score(track);
    assertThat(score.crossTrackRmsM().getAsDouble()).isCloseTo(10.0, within(0.01));
    assertThat(score.crossTrackRmsWholeLegsM().getAsDouble()).isBetween(90.0, 110.0);
  }

  @Test
  void score_flightTooHigh_tellsAltitudeErrors() {
    FlightScore score = score(SyntheticFlight.northward(0.0, 12.0));
    assertThat(score.altitudeRmsM().getAsDouble()).isCloseTo(12.0, within(1e-9));
    assertThat(score.altitudeMaxErrorM().getAsDouble()).isCloseTo(12.0, within(1e-9));
    assertThat(score.waypoints().get(1).altitudeErrorM().getAsDouble())
        .isCloseTo(12.0, within(1e-9));
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
    List<FlightSample> track =
        List.of(
            SyntheticFlight.sample(
                0.0, 0.0, 1000.0, 300.0,
                0), // 445 m over the waypoint, 455 m when leaving the circle
            SyntheticFlight.sample(40.0, 0.0, 3000.0, 590.0, 1));
    assertThat(score(track).waypoints().get(0).captured()).isTrue();
    List<FlightSample> lower =
        List.of(
            SyntheticFlight.sample(0.0, 0.0, 1000.0, 270.0, 0),
            SyntheticFlight.sample(40.0, 0.0, 3000.0, 590.0, 1));
    assertThat(score(lower).waypoints().get(0).captured()).isFalse();
  }

  @Test
  void score_waypointNeverTargeted_hasNoNumbers() {
    FlightScore score = score(SyntheticFlight.northward(0.0, 0.0).subList(0, 300));
    WaypointResult second = score.waypoints().get(1);
    assertThat(second.missM()).isEmpty();
    assertThat(second.captured()).isFalse();
    assertThat(score.crossTrackRmsM()).isEmpty();
    assertThat(score.success()).isFalse();
  }

  @Test
  void score_acrossTheDateLine_measuresTheShortWay() {
    PlannedWaypoint waypoint =
        new PlannedWaypoint(
            "date line", 179.9999, 0.0, OptionalDouble.empty(), 100.0, OptionalDouble.empty());
    FlightSample sample =
        new FlightSample(0.0, -179.9999, 0.0, 500.0, 0, 0, 0, 50, 50, 0, 0, false, "CRUISE");
    WaypointResult result =
        FlightScorer.score(
                new FlightPlan(Optional.empty(), List.of(waypoint)),
                List.of(sample),
                FlightOutcome.clean())
            .waypoints()
            .get(0);
    assertThat(result.missM().getAsDouble())
        .isCloseTo(22.26, within(0.01)); // 0.0002° of the equator
    assertThat(result.altitudeErrorM()).isEmpty();
  }

  @Test
  void score_takeOff_countsFromScreenHeightOn() {
    Home home =
        new Home(
            SyntheticFlight.LONGITUDE,
            SyntheticFlight.LATITUDE,
            100.0,
            0.0,
            OptionalDouble.empty());
    FlightPlan plan = new FlightPlan(Optional.of(home), SyntheticFlight.twoWaypoints().waypoints());
    FlightSample roll =
        new FlightSample(0.0, -157.9, 21.3, 100.0, 0, 0.9, 0, 5.0, 5.0, 0, 0, true, "ROLL");
    FlightSample low =
        new FlightSample(1.0, -157.9, 21.3, 110.0, 0, 0.8, 0, 30.0, 30.0, 0, 0, false, "CLIMB");
    FlightSample high =
        new FlightSample(2.0, -157.9, 21.3, 116.0, 0, -0.3, 0, 35.0, 35.0, 0, 0, false, "CLIMB");
    FlightScore before = FlightScorer.score(plan, List.of(roll, low), FlightOutcome.clean());
    assertThat(before.tookOff()).isFalse();
    assertThat(before.maxBankRad()).isEmpty();
    FlightScore after = FlightScorer.score(plan, List.of(roll, low, high), FlightOutcome.clean());
    assertThat(after.tookOff()).isTrue();
    assertThat(after.maxBankRad().getAsDouble()).isEqualTo(0.3);
    assertThat(after.minAirspeedMps().getAsDouble()).isEqualTo(35.0);
  }

  @Test
  void success_crashAfterTheLastWaypoint_isNone() {
    FlightScore score =
        FlightScorer.score(
            SyntheticFlight.twoWaypoints(),
            SyntheticFlight.northward(0, 0),
            new FlightOutcome(true, false, List.of()));
    assertThat(score.captured()).isEqualTo(2);
    assertThat(score.success()).isFalse();
  }
}
