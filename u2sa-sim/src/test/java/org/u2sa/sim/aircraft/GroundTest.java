package org.u2sa.sim.aircraft;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.sim.world.Terrain;
import org.u2sa.sim.world.World;

class GroundTest {
  private static final RunwayStart RUNWAY = new RunwayStart(8.0, 50.0, 100.0, 0.5);
  private static final ControlInputs PARKED = ControlInputs.neutral().withBrakes(1.0, 1.0);
  private static final double METRE_DEG = Math.toDegrees(1.0 / 6_378_137.0);

  @Test
  void step_idleWithBrakes_standsStill() {
    Cessna172 aircraft = Cessna172.onRunway(RUNWAY, Wind.calm(), true);
    aircraft.step(PARKED, 5.0);
    AircraftMotion settled = aircraft.state();
    aircraft.step(PARKED, 60.0);
    AircraftMotion later = aircraft.state();
    assertThat(later.latitudeDeg()).isCloseTo(settled.latitudeDeg(), within(1e-4 * METRE_DEG));
    assertThat(later.longitudeDeg()).isCloseTo(settled.longitudeDeg(), within(1e-4 * METRE_DEG));
    assertThat(later.headingRad()).isCloseTo(settled.headingRad(), within(1e-6));
    assertThat(later.velocityNorthMps()).isCloseTo(0.0, within(1e-6));
    assertThat(later.velocityDownMps()).isCloseTo(0.0, within(1e-6));
    assertThat(later.heightAboveGroundM()).isCloseTo(0.0, within(0.01));
    assertThat(later.engineRpm()).isBetween(600.0, 700.0);
    assertThat(later.weightOnWheels()).isTrue();
    assertThat(later.loadFactor()).isCloseTo(1.0, within(3e-3));
  }

  @Test
  void step_brakesInGustyCrosswind_movesLessThanATyresGive() {
    Cessna172 aircraft = Cessna172.onRunway(RUNWAY, Wind.turbulent(2.0, 10.0, 3L), true);
    aircraft.step(PARKED, 60.0);
    assertThat(aircraft.state().latitudeDeg())
        .isCloseTo(RUNWAY.latitudeDeg(), within(0.05 * METRE_DEG));
    assertThat(aircraft.state().headingRad()).isCloseTo(RUNWAY.headingRad(), within(0.02));
  }

  @Test
  void step_brakes_stopTheRollWithinTheHandbooksDistance() {
    Cessna172 aircraft = rolling(25.0, 0.0);
    double before = aircraft.state().latitudeDeg();
    aircraft.step(PARKED, 20.0);
    double distance = (aircraft.state().latitudeDeg() - before) / METRE_DEG;
    assertThat(aircraft.state().velocityNorthMps()).isCloseTo(0.0, within(1e-3));
    assertThat(distance)
        .isBetween(90.0, 220.0); // handbook: ground roll 540 ft = 165 m from about 50 kt
  }

  @Test
  void step_noBrakes_rollsOn() {
    Cessna172 aircraft = rolling(15.0, 0.0);
    aircraft.step(ControlInputs.neutral(), 10.0);
    assertThat(aircraft.state().velocityNorthMps()).isBetween(10.0, 14.9);
  }

  @Test
  void step_rightPedal_turnsTaxiingRight() {
    Cessna172 aircraft = rolling(4.0, 0.0);
    aircraft.step(ControlInputs.neutral().withSurfaces(0.0, 0.0, 1.0).withThrottle(0.2), 5.0);
    // a wheel base of 1.65 m and 10° of steering: radius 9.4 m, about 0.4 rad/s at 4 m/s
    assertThat(aircraft.state().yawRateRadPerS()).isBetween(0.15, 0.6);
  }

  @Test
  void step_leftBrake_turnsTaxiingLeft() {
    Cessna172 aircraft = rolling(4.0, 0.0);
    aircraft.step(ControlInputs.neutral().withBrakes(0.5, 0.0), 1.0);
    assertThat(aircraft.state().yawRateRadPerS()).isLessThan(-0.02);
  }

  @Test
  void step_crosswindWithoutPilot_weathercocksIntoIt() {
    Cessna172 aircraft =
        Cessna172.onRunway(
            new RunwayStart(8.0, 50.0, 100.0, 0.0), Wind.constant(Math.toRadians(90.0), 8.0), true);
    aircraft.step(ControlInputs.neutral().withThrottle(1.0), 10.0);
    assertThat(Math.sin(aircraft.state().headingRad())).isGreaterThan(0.01);
  }

  @Test
  void step_fullThrottleStanding_turnsTheHandbooksStaticRpm() {
    Cessna172 aircraft = Cessna172.onRunway(RUNWAY, Wind.calm(), true);
    aircraft.step(PARKED.withThrottle(1.0), 6.0);
    assertThat(aircraft.state().engineRpm()).isBetween(2_300.0, 2_420.0); // 172P type certificate
  }

  @Test
  void step_mixtureCutOff_stopsTheEngineAndStarterRunsItAgain() {
    Cessna172 aircraft = Cessna172.onRunway(RUNWAY, Wind.calm(), true);
    aircraft.step(PARKED.withMixture(0.0), 10.0);
    assertThat(aircraft.state().engineRpm()).isZero();
    aircraft.step(PARKED, 5.0);
    assertThat(aircraft.state().engineRpm()).isZero();
    aircraft.startEngine();
    aircraft.step(PARKED, 5.0);
    assertThat(aircraft.state().engineRpm()).isBetween(600.0, 700.0);
  }

  @Test
  void step_engineOff_staysOff() {
    Cessna172 aircraft = Cessna172.onRunway(RUNWAY, Wind.calm(), false);
    aircraft.step(ControlInputs.neutral().withThrottle(1.0), 60.0);
    assertThat(aircraft.state().engineRpm()).isZero();
    assertThat(aircraft.state().velocityNorthMps()).isCloseTo(0.0, within(1e-6));
  }

  /** On the runway, heading north, rolling. */
  @ParameterizedTest
  @ValueSource(doubles = {0.0, 180.0})
  void step_rollingUpOrDownASlope_followsItAndFeelsItsWeight(double uphillDeg) {
    World sloping =
        World.at(new Geodetic(8.0, 50.0, 100.0))
            .with(Terrain.slope(0.05, Math.toRadians(uphillDeg)))
            .with(Wind.calm());
    RunwayStart north = new RunwayStart(8.0, 50.0, 100.0, 0.0);
    Cessna172 aircraft = Cessna172.onRunway(north, sloping, true);
    ControlInputs takingOff = ControlInputs.neutral().withThrottle(1.0);
    aircraft.step(takingOff, 6.0);

    for (int i = 0; i < 240; i++) {
      aircraft.step(takingOff, 1.0 / 120.0);
      AircraftMotion state = aircraft.state();
      assertThat(state.heightAboveGroundM()).isCloseTo(0.0, within(0.05));
      assertThat(state.loadFactor()).isCloseTo(1.0, within(0.1));
    }
    assertThat(aircraft.state().velocityNorthMps()).isGreaterThan(10.0);
  }

  private static Cessna172 rolling(double speedMps, double headingRad) {
    FlightStart start =
        new FlightStart(
            8.0,
            50.0,
            100.0 + LandingGear.STANDING_M,
            100.0,
            headingRad,
            speedMps,
            LandingGear.STANDING_PITCH_RAD,
            0.0,
            0.0,
            LandingGear.STANDING_PITCH_RAD,
            PistonEngine.IDLE_RPM,
            0.0);
    return Cessna172.inFlight(start, Wind.calm());
  }
}
