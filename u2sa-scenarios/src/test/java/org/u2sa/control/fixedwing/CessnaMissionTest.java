package org.u2sa.control.fixedwing;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.u2sa.control.fixedwing.SimulatedFlight.Loop;
import org.u2sa.sim.atmosphere.Wind;

/** Whole flights, own take-off included, against the simulated Cessna, scored by truth. */
class CessnaMissionTest {
  private static final double GOLDEN_ANGLE_DEG = 137.5; // spreads wind directions over few seeds
  private static final double FIELD_M = 5.3;
  private static final double GUSTS_PER_WIND = 0.15; // half as much again as MIL-F-8785C has

  static Stream<Arguments> few() {
    return Stream.of(
        Arguments.of(0, 8.0, Loop.lockstep()),
        Arguments.of(2, 8.0, Loop.flightGear()),
        Arguments.of(3, 0.0, Loop.lockstep()));
  }

  static Stream<Arguments> many() {
    return IntStream.range(0, 24)
        .mapToObj(
            seed ->
                Arguments.of(
                    seed, seed % 3 == 0 ? 8.0 : seed / 3.0, loops()[seed % loops().length]));
  }

  private static Loop[] loops() {
    return new Loop[] {
      Loop.lockstep(), Loop.flightGear(), new Loop(20.0, 0.15, 1.3), new Loop(20.0, 0.15, 0.7)
    };
  }

  @ParameterizedTest(name = "seed {0}, wind {1} m/s, {2}")
  @MethodSource("few")
  void fly_tenWaypoints_allCapturedWithinBounds(int seed, double windMps, Loop loop) {
    requireGood(flown(Course.ten(), seed, windMps, loop));
  }

  @Tag("long")
  @ParameterizedTest(name = "seed {0}, wind {1} m/s, {2}")
  @MethodSource("many")
  void fly_manyWinds_allCapturedWithinBounds(int seed, double windMps, Loop loop) {
    requireGood(flown(Course.ten(), seed, windMps, loop));
  }

  @Tag("long")
  @ParameterizedTest(name = "seed {0}, wind {1} m/s, {2}")
  @MethodSource("many")
  void fly_coursesNobodyTunedFor_allCapturedWithinBounds(int seed, double windMps, Loop loop) {
    requireGood(flown(Course.random(seed, FIELD_M), seed, windMps, loop));
  }

  private static FlightScore flown(Course course, int seed, double windMps, Loop loop) {
    double from = Math.toRadians(seed * GOLDEN_ANGLE_DEG % 360.0);
    Wind wind = Wind.constant(from, windMps).withGusts(GUSTS_PER_WIND * windMps, seed);
    return new SimulatedFlight(TestTuning.standard(), course, wind, loop, FIELD_M).fly();
  }

  private static void requireGood(FlightScore score) {
    assertThat(score.crashed).as("crashed: %s", score).isFalse();
    assertThat(score.stalled).as("stalled: %s", score).isFalse();
    assertThat(score.worstMissM()).as("miss: %s", score).isLessThan(100.0);
    assertThat(score.crossRmsM()).as("cross-track: %s", score).isLessThan(15.0);
    assertThat(score.worstLevelM).as("altitude: %s", score).isLessThan(15.0);
    assertThat(score.worstBankDeg).as("bank: %s", score).isLessThan(35.0);
    assertThat(score.slowestMps).as("airspeed: %s", score).isGreaterThan(28.5);
    assertThat(score.worstRunwayOffsetM).as("centreline: %s", score).isLessThan(8.0);
  }
}
