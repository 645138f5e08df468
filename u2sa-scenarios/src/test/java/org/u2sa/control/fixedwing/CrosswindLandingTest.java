package org.u2sa.control.fixedwing;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.u2sa.sim.aircraft.AircraftMotion;
import org.u2sa.sim.aircraft.Cessna172;
import org.u2sa.sim.aircraft.ControlInputs;
import org.u2sa.sim.aircraft.FlightStart;
import org.u2sa.sim.atmosphere.Wind;

/**
 * Approaches to a runway that leads east, in wind and its gusts, judged by the simulator's truth.
 */
class CrosswindLandingTest {
  private static final double LONGITUDE_DEG = -157.943183; // of the threshold
  private static final double LATITUDE_DEG = 21.325247;
  private static final double DEG_PER_M = 1.0 / 103_700.0; // of longitude, there
  private static final double FIELD_M = 5.3;
  private static final double BEFORE_M = 5_500.0;
  private static final double TOUCH_DOWN_M = 300.0;
  private static final double GLIDE_M = 4_500.0;
  private static final double HIGH_M = 250.0;
  private static final double SPEED_MPS = 38.0;
  private static final double DT_S = 0.025;
  private static final double HALF_WIDTH_M = 22.0;
  private static final double TIP_TOUCHES_DEG = 22.0;

  private Autopilot autopilot;
  private Cessna172 aircraft;
  private double farthestOffM;
  private double steepestOnWheelsRad;
  private double touchDownSinkMps;
  private boolean touched;

  private FlightState state() {
    return SimulatedFlight.see(aircraft.state(), LONGITUDE_DEG, LATITUDE_DEG);
  }

  private void approach(Wind wind) {
    double fromNorth = -wind.speedMps() * Math.cos(wind.fromRad());
    double crab = Math.asin(fromNorth / SPEED_MPS);
    aircraft =
        Cessna172.inFlight(
            new FlightStart(
                LONGITUDE_DEG - BEFORE_M * DEG_PER_M,
                LATITUDE_DEG,
                HIGH_M,
                FIELD_M,
                Math.PI / 2.0 - crab,
                SPEED_MPS,
                0.09,
                0.0,
                0.0,
                0.09,
                2_000.0,
                0.0),
            wind);
    autopilot = new Autopilot(TestTuning.standard());
    farthestOffM = 0.0;
    steepestOnWheelsRad = 0.0;
    touched = false;
  }

  /** What a planner that leads down a glide path says. */
  private static GuidanceTarget target(FlightState state) {
    double look = Math.max(150.0, 5.0 * state.groundSpeedMps());
    double share = Limit.within(0.0, (TOUCH_DOWN_M - state.eastM() - look) / GLIDE_M, 1.0);
    return new GuidanceTarget(
        -state.northM(), look, FIELD_M + share * (HIGH_M - FIELD_M), OptionalDouble.of(SPEED_MPS));
  }

  private void step() {
    FlightState state = state();
    Surfaces s = autopilot.step(state, Optional.of(target(state)));
    AircraftMotion truth = aircraft.state();
    if (truth.weightOnWheels()) {
      touchDownSinkMps = touched ? touchDownSinkMps : truth.velocityDownMps();
      touched = true;
      farthestOffM = Math.max(farthestOffM, Math.abs(state.northM()));
      steepestOnWheelsRad = Math.max(steepestOnWheelsRad, Math.abs(truth.rollRad()));
    }
    aircraft.step(
        ControlInputs.limited(
            s.aileron(),
            s.elevator(),
            s.rudder(),
            s.throttle(),
            s.mixture(),
            s.flaps(),
            s.brakes(),
            s.brakes()),
        DT_S);
  }

  private void land(Wind wind) {
    approach(wind);
    boolean stands = false;
    for (double t = 0.0; t < 400.0 && !stands; t += DT_S) {
      step();
      stands =
          touched && autopilot.phase() == FlightPhase.STOPPED && state().groundSpeedMps() < 0.5;
      assertThat(aircraft.state().crashed()).as("crashed after %.1f s", t).isFalse();
    }
    for (double t = 0.0; t < 30.0; t += DT_S) {
      step();
    }
    assertThat(stands).isTrue();
    assertThat(aircraft.state().crashed()).isFalse();
    assertThat(farthestOffM).isLessThan(HALF_WIDTH_M);
    assertThat(Math.toDegrees(steepestOnWheelsRad)).isLessThan(TIP_TOUCHES_DEG);
    assertThat(touchDownSinkMps).isLessThan(3.3);
  }

  @ParameterizedTest(name = "{0} m/s from {1} deg, seed {2}")
  @CsvSource({"0, 0, 1", "8, 225, 8", "10, 0, 2", "12, 180, 4", "12, 0, 9", "12, 225, 9"})
  void step_windAcrossTheRunway_standsOnIt(double mps, double fromDeg, long seed) {
    land(Wind.gusty(Math.toRadians(fromDeg), mps, seed));
  }

  static Stream<Arguments> matrix() {
    return IntStream.range(100, 110)
        .boxed()
        .flatMap(
            seed ->
                Stream.of(4, 8, 10)
                    .flatMap(
                        mps ->
                            IntStream.range(0, 8)
                                .mapToObj(eighth -> Arguments.of(mps, 45 * eighth, seed))));
  }

  @Tag("long")
  @ParameterizedTest(name = "{0} m/s from {1} deg, seed {2}")
  @MethodSource("matrix")
  void step_manyWinds_standsOnTheRunway(double mps, double fromDeg, long seed) {
    land(Wind.gusty(Math.toRadians(fromDeg), mps, seed));
  }

  /** Lands, or goes around and circles over the runway; breaks nothing either way. */
  private void landOrStayUp(Wind wind) {
    approach(wind);
    boolean refused = false;
    boolean stands = false;
    for (double t = 0.0; t < 400.0 && !stands; t += DT_S) {
      refused |= autopilot.phase() == FlightPhase.GO_AROUND;
      if (refused) {
        circle();
      } else {
        step();
      }
      stands =
          touched && autopilot.phase() == FlightPhase.STOPPED && state().groundSpeedMps() < 0.5;
      assertThat(aircraft.state().crashed())
          .as("crashed after %.1f s, %s", t, autopilot.phase())
          .isFalse();
    }
    assertThat(stands).isNotEqualTo(refused);
    assertThat(farthestOffM).isLessThan(HALF_WIDTH_M);
    assertThat(aircraft.state().weightOnWheels()).isEqualTo(stands);
  }

  /** Go-arounds from a gust's sink had come down on the ground: the nose fell for airspeed. */
  @ParameterizedTest(name = "{0} m/s from {1} deg, seed {2}")
  @CsvSource({"13, 0, 510", "13, 0, 514", "13, 0, 520", "13, 180, 546", "14, 180, 511"})
  void step_windAboutTheLimit_landsOrStaysUp(double mps, double fromDeg, long seed) {
    landOrStayUp(Wind.gusty(Math.toRadians(fromDeg), mps, seed));
  }

  static Stream<Arguments> acrossAboutTheLimit() {
    return IntStream.range(700, 720)
        .boxed()
        .flatMap(
            seed ->
                Stream.of(12, 13, 14, 15, 17)
                    .flatMap(mps -> Stream.of(0, 180).map(from -> Arguments.of(mps, from, seed))));
  }

  @Tag("long")
  @ParameterizedTest(name = "{0} m/s from {1} deg, seed {2}")
  @MethodSource("acrossAboutTheLimit")
  void step_manyWindsAboutTheLimit_landsOrStaysUp(double mps, double fromDeg, long seed) {
    landOrStayUp(Wind.gusty(Math.toRadians(fromDeg), mps, seed));
  }

  @Test
  void step_moreCrosswindThanAllowed_staysUpAndSaysWhy() {
    approach(Wind.gusty(Math.PI, 19.0, 3));
    boolean refused = false;
    for (double t = 0.0; t < 300.0; t += DT_S) {
      step();
      refused |= autopilot.phase() == FlightPhase.GO_AROUND;
    }

    assertThat(refused).isTrue();
    assertThat(touched).isFalse();
    assertThat(state().heightM()).isGreaterThan(60.0);
    assertThat(autopilot.phase()).isEqualTo(FlightPhase.GO_AROUND);
    assertThat(autopilot.refusalWords())
        .startsWith("not landing: ")
        .contains("m/s of wind from the right across the approach, MAX CROSSWIND is 13.0 m/s");
  }

  /** Goes around, and circles over the runway, as planners do at the end of a mission. */
  @ParameterizedTest(name = "{0} m/s from {1} deg, seed {2}")
  @CsvSource({
    "17, 0, 4",
    "17, 0, 7",
    "17, 180, 1",
    "17, 180, 5",
    "19, 0, 5",
    "19, 180, 4",
    "19, 180, 5"
  })
  void step_goAroundInStrongWind_climbsAndCirclesWithoutAStall(
      double mps, double fromDeg, long seed) {
    approach(Wind.gusty(Math.toRadians(fromDeg), mps, seed));
    boolean refused = false;
    for (double t = 0.0; t < 400.0; t += DT_S) {
      refused |= autopilot.phase() == FlightPhase.GO_AROUND;
      if (refused) {
        circle();
      } else {
        step();
      }
      AircraftMotion truth = aircraft.state();
      assertThat(truth.stalled() || truth.crashed() || truth.weightOnWheels())
          .as("stalled or down after %.1f s, %.1f m above ground", t, state().heightM())
          .isFalse();
    }
    assertThat(refused).isTrue();
    assertThat(autopilot.phase()).isEqualTo(FlightPhase.GO_AROUND);
  }

  /** A planner tries again whose approach begins lower than the safe height: it decides anew. */
  @Test
  void step_leadsToTheNextApproachAfterARefusal_refusesNoLonger() {
    approach(Wind.gusty(Math.PI, 19.0, 3));
    while (autopilot.phase() != FlightPhase.GO_AROUND) {
      step();
    }
    for (double t = 0.0; t < 10.0; t += DT_S) {
      circle(41.0);
    }
    assertThat(autopilot.phase()).isEqualTo(FlightPhase.GO_AROUND);
    circle(56.0);
    circle(56.0);

    assertThat(autopilot.phase()).isEqualTo(FlightPhase.CRUISE);
  }

  /** A planner breaks off its approach: a gust that takes airspeed must not bring the nose down. */
  @ParameterizedTest(name = "{0} m/s from {1} deg, seed {2}")
  @CsvSource({"12, 270, 2", "12, 270, 3", "12, 270, 7", "12, 270, 8"})
  void step_leadsUpLowOverTheRunway_climbsAtOnce(double mps, double fromDeg, long seed) {
    approach(Wind.gusty(Math.toRadians(fromDeg), mps, seed));
    while (state().heightM() > 22.0) {
      step();
    }
    double lowestM = state().heightM();
    for (double t = 0.0; t < 15.0; t += DT_S) {
      FlightState now = state();
      lowestM = Math.min(lowestM, now.heightM());
      fly(new GuidanceTarget(-now.northM(), 400.0, FIELD_M + 56.0, OptionalDouble.empty()));
    }

    assertThat(aircraft.state().stalled()).isFalse();
    assertThat(lowestM).isGreaterThan(5.0);
    assertThat(state().heightM()).isGreaterThan(40.0);
  }

  private void circle() {
    circle(0.0);
  }

  /**
   * What a planner says that has come to the end of a mission to land: it circles there.
   *
   * @param heightM above the field
   */
  private void circle(double heightM) {
    FlightState state = state();
    double radius = 300.0;
    double angle = Math.atan2(state.eastM() - TOUCH_DOWN_M, state.northM()) + 0.5;
    GuidanceTarget there =
        new GuidanceTarget(
            radius * Math.cos(angle) - state.northM(),
            TOUCH_DOWN_M + radius * Math.sin(angle) - state.eastM(),
            FIELD_M + heightM,
            OptionalDouble.of(SPEED_MPS));
    fly(there);
  }

  private void fly(GuidanceTarget there) {
    Surfaces s = autopilot.step(state(), Optional.of(there));
    aircraft.step(
        ControlInputs.limited(
            s.aileron(),
            s.elevator(),
            s.rudder(),
            s.throttle(),
            s.mixture(),
            s.flaps(),
            s.brakes(),
            s.brakes()),
        DT_S);
  }

  /** Four flights at 12 m/s had stalled, all where the nose came up. */
  @ParameterizedTest(name = "seed {0}")
  @CsvSource({"2", "3", "11", "13"})
  void step_takeOffInGusts_doesNotStall(long seed) {
    for (int eighth = 0; eighth < 8; eighth++) {
      Wind wind = Wind.gusty(Math.toRadians(45.0 * eighth), 12.0, seed);
      FlightScore score =
          new SimulatedFlight(
                  TestTuning.standard(),
                  Course.ten(),
                  wind,
                  SimulatedFlight.Loop.lockstep(),
                  FIELD_M)
              .fly(100.0);
      assertThat(score.stalled).as("stalled: %d deg, %s", 45 * eighth, score).isFalse();
      assertThat(score.crashed).as("crashed: %d deg, %s", 45 * eighth, score).isFalse();
    }
  }
}
