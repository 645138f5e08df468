package org.u2sa.control.fixedwing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.u2sa.messages.AircraftState;
import org.u2sa.messages.StateInformation;

class FlightStateReaderTest {
  private final FlightStateReader reader = new FlightStateReader();

  @Test
  void read_levelTurn_eulerRatesBecomeBodyRates() {
    double bank = Math.toRadians(30.0);
    StateInformation turning = state().phi(bank).theta(0.1).psiDot(0.12);
    FlightState seen = reader.read(turning).orElseThrow();
    assertThat(seen.rollRate()).isCloseTo(-0.12 * Math.sin(0.1), within(1e-12));
    assertThat(seen.pitchRate()).isCloseTo(0.12 * Math.sin(bank) * Math.cos(0.1), within(1e-12));
    assertThat(seen.yawRate()).isCloseTo(0.12 * Math.cos(bank) * Math.cos(0.1), within(1e-12));
  }

  @Test
  void read_movingToTheLeftThroughTheAir_airComesFromTheLeft() {
    FlightState seen = reader.read(state().fluidyDot(5.0)).orElseThrow(); // BODY: y is left
    assertThat(seen.betaRad()).isNegative();
    assertThat(seen.trueAirspeedMps()).isCloseTo(Math.sqrt(43 * 43 + 25 + 4), within(1e-9));
  }

  @Test
  void read_secondState_positionInMetresFromTheFirst() {
    reader.read(state());
    FlightState seen = reader.read(state().y(21.301).x(-157.9)).orElseThrow();
    assertThat(seen.northM()).isCloseTo(110.7, within(0.1));
    assertThat(seen.eastM()).isCloseTo(0.0, within(0.1));
  }

  @Test
  void read_stateOfAnyVehicle_isOneInTheAirWithItsAirspeedCalibratedByDensity() {
    FlightState seen = reader.read(state().z(2000.0)).orElseThrow();
    assertThat(seen.onGround()).isFalse();
    assertThat(seen.heightM()).isGreaterThan(100.0);
    assertThat(seen.calibratedAirspeedMps() / seen.trueAirspeedMps())
        .isCloseTo(Math.sqrt(1.0066 / 1.225), within(1e-4)); // ISA density at 2000 m
  }

  @Test
  void read_aircraftState_takesWhatOnlyAircraftHave() {
    AircraftState parked = new AircraftState();
    for (var field : org.u2sa.messages.StateField.values()) {
      state().number(field).ifPresent(value -> parked.number(field, value));
    }
    parked.heightAboveGround(0.4).calibratedAirspeed(1.5).engineRpm(650.0);
    parked.weightOnWheels(true).engineStarting(true);
    FlightState seen = reader.read(parked).orElseThrow();
    assertThat(seen.heightM()).isEqualTo(0.4);
    assertThat(seen.calibratedAirspeedMps()).isEqualTo(1.5);
    assertThat(seen.engineRpm()).isEqualTo(650.0);
    assertThat(seen.onGround()).isTrue();
    assertThat(seen.engineStarting()).isTrue();
  }

  @Test
  void read_attitudeMissing_isEmptyAndNamesIt() {
    StateInformation poor = new StateInformation().x(0.0).y(0.0).z(0.0);
    assertThat(reader.read(poor)).isEmpty();
    assertThat(reader.missing(poor)).contains("phi", "theta", "psi", "fluidxDot");
  }

  @Test
  void read_positionLost_isTheLastOneUnlessThereWasNone() {
    StateInformation without = new StateInformation().z(290.0).zDot(0.0);
    without.phi(0.0).theta(0.05).psi(1.57).phiDot(0.0).thetaDot(0.0).psiDot(0.0).fluidxDot(43.0);
    assertThat(reader.read(without)).isEmpty();
    assertThat(reader.missing(without)).containsExactly("x", "y", "xDot", "yDot");

    reader.read(state());
    FlightState before = reader.read(state().y(21.301)).orElseThrow();
    FlightState after = reader.read(without).orElseThrow();

    assertThat(after.northM()).isCloseTo(before.northM(), within(0.01));
    assertThat(after.eastMps()).isEqualTo(43.0);
    assertThat(after.altitudeM()).isEqualTo(290.0);
  }

  private static StateInformation state() {
    StateInformation state = new StateInformation().x(-157.9).y(21.3).z(300.0);
    state.xDot(43.0).yDot(0.0).zDot(0.0);
    state.phi(0.0).theta(0.05).psi(1.57).phiDot(0.0).thetaDot(0.0).psiDot(0.0);
    return state.fluidxDot(43.0).fluidyDot(0.0).fluidzDot(2.0);
  }
}
