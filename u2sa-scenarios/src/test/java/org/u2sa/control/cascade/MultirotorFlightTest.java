package org.u2sa.control.cascade;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.sim.atmosphere.Wind;

/** Multirotors by AllocatingControl, scored against the truth of the simulated aircraft. */
class MultirotorFlightTest {
  @ParameterizedTest
  @ValueSource(ints = {4, 6, 8})
  void fly_toPointsInCalmAir_reachesEachAndHolds(int rotors) {
    try (RotorFlight flight = new RotorFlight(rotors, Wind.calm())) {
      flight.target = Point.of(0.0, 0.0, -5.0);
      flight.fly(10.0);
      assertThat(flight.worstM(2.0)).isLessThan(0.2);

      flight.target = Point.of(20.0, -10.0, -8.0);
      flight.fly(20.0);

      assertThat(flight.worstM(3.0)).isLessThan(0.3);
      assertThat(flight.steepestDeg(20.0)).isLessThan(36.0);
    }
  }

  @ParameterizedTest
  @CsvSource({"6, 0.5, 1", "6, 2.6, 2", "10, -1.2, 3"})
  void fly_inGusts_holdsItsPlace(double windMps, double fromRad, long seed) {
    try (RotorFlight flight = new RotorFlight(6, Wind.gusty(fromRad, windMps, seed))) {
      flight.target = Point.of(0.0, 0.0, -20.0);
      flight.fly(40.0);

      assertThat(flight.worstM(20.0)).isLessThan(1.0);
    }
  }

  @Test
  void standing_withoutATargetAbove_doesNotLift() {
    try (RotorFlight flight = new RotorFlight(4, Wind.constant(0.3, 6.0))) {
      flight.fly(5.0);
      flight.flyUntold(5.0);

      assertThat(flight.aircraft.stands()).isTrue();
      assertThat(flight.kit.percent("ROTOR 1")).isZero();
      assertThat(flight.fastestMps(5.0)).isLessThan(0.01);
    }
  }

  @Test
  void fly_downToTheGround_landsAndStopsItsRotors() {
    try (RotorFlight flight = new RotorFlight(4, Wind.calm())) {
      flight.target = Point.of(0.0, 0.0, -6.0);
      flight.fly(8.0);

      flight.target = Point.of(0.0, 0.0, 1.0); // below the ground
      flight.fly(15.0);

      assertThat(flight.aircraft.isAground()).isFalse();
      assertThat(flight.aircraft.stands()).isTrue();
      assertThat(flight.kit.percent("ROTOR 1")).isZero();
    }
  }

  /** The wind pushes the landed aircraft along; a noisy velocity never shows standstill. */
  @ParameterizedTest
  @CsvSource({"10, 0", "10, 0.15"})
  void fly_downInWind_landsUprightAndStopsItsRotors(double windMps, double errorMps) {
    try (RotorFlight flight = new RotorFlight(4, Wind.constant(0.8, windMps))) {
      flight.velocityErrorMps = errorMps;
      flight.target = Point.of(0.0, 0.0, -6.0);
      flight.fly(15.0);

      flight.target = Point.of(0.5, 0.5, 0.5); // below the ground, and where the wind comes from
      flight.fly(30.0);

      assertThat(flight.aircraft.isAground()).isFalse();
      assertThat(flight.aircraft.stands()).isTrue();
      assertThat(flight.kit.percent("ROTOR 1")).isZero();
      assertThat(flight.fastestMps(15.0)).isLessThan(0.01);
    }
  }

  /** A slow descent with a noisy velocity is not taken for the ground. */
  @Test
  void fly_slowlyDownWithNoise_staysInTheAir() {
    try (RotorFlight flight = new RotorFlight(4, Wind.constant(0.8, 6.0))) {
      flight.velocityErrorMps = 0.2;
      flight.target = Point.of(0.0, 0.0, -20.0);
      flight.fly(20.0);
      for (int i = 0; i < 40; i++) {
        flight.target = Point.of(0.0, 0.0, -20.0 + 0.15 * i); // stepwise down
        flight.fly(1.0);
        assertThat(flight.worstM(0.5)).isLessThan(1.0);
      }
    }
  }

  @Test
  void navigationStops_inFlight_hoversWhereItIs() {
    try (RotorFlight flight = new RotorFlight(6, Wind.constant(0.3, 5.0))) {
      flight.target = Point.of(30.0, 0.0, -10.0);
      flight.fly(8.0);

      flight.flyUntold(15.0);

      assertThat(flight.fastestMps(5.0)).isLessThan(0.3);
      assertThat(flight.aircraft.truth().position().z()).isBetween(7.0, 12.0);
    }
  }

  @Test
  void swap_inFlight_neitherFallsNorTilts() {
    try (RotorFlight flight = new RotorFlight(6, Wind.constant(0.3, 6.0))) {
      flight.target = Point.of(0.0, 0.0, -10.0);
      flight.fly(20.0);
      double before = flight.steepestDeg(3.0);

      flight.swap();
      flight.fly(5.0);

      assertThat(flight.worstM(5.0)).isLessThan(0.2);
      assertThat(flight.steepestDeg(5.0)).isLessThan(before + 2.0);
    }
  }

  /** The rotors of the other control lift less than the weight. */
  @Test
  void swap_whileItFalls_brakesAtOnce() {
    try (RotorFlight flight = new RotorFlight(6, Wind.calm())) {
      flight.target = Point.of(0.0, 0.0, -30.0);
      flight.fly(25.0);

      flight.flyBlind(0.85 * flight.kit.percent("ROTOR 1"), 2.0);
      double before = flight.lowestM(0.1);
      double fall = flight.fastestMps(0.1);
      flight.fly(8.0);

      assertThat(fall).isGreaterThan(3.0);
      assertThat(before - flight.lowestM(8.0)).isLessThan(2.0);
    }
  }

  @Test
  void weaken_oneRotorOfEight_flightGoesOn() {
    try (RotorFlight flight = new RotorFlight(8, Wind.calm())) {
      flight.target = Point.of(0.0, 0.0, -15.0);
      flight.fly(15.0);

      flight.aircraft.weaken("ROTOR 3", 0.0);
      flight.fly(20.0);

      assertThat(flight.aircraft.isAground()).isFalse();
      assertThat(flight.worstM(5.0)).isLessThan(0.5);
    }
  }

  /**
   * With neighbours that turn the same way, rotors 1, 2 and 3, 4, four of six can be lost (Du et
   * al., Controllability Analysis for Multirotor Helicopters, 2015, configuration PPNNPN).
   */
  @ParameterizedTest
  @ValueSource(ints = {2, 3, 4, 5})
  void weaken_oneRotorOfSix_staysUpNearItsPlace(int rotor) {
    try (RotorFlight flight =
        new RotorFlight(new int[] {1, 1, -1, -1, 1, -1}, Wind.gusty(0.5, 5.0, rotor))) {
      flight.target = Point.of(0.0, 0.0, -15.0);
      flight.fly(15.0);

      flight.aircraft.weaken("ROTOR " + rotor, 0.0);
      flight.fly(20.0);

      assertThat(flight.aircraft.isAground()).isFalse();
      assertThat(flight.worstM(5.0)).isLessThan(2.0);
    }
  }

  @Test
  void disarmed_onTheGround_staysDownUntilArmedAndToldToRise() {
    try (RotorFlight flight = new RotorFlight(4, Wind.calm())) {
      flight.kit.send(Channels.ARMING_STATE, new ArmingState().armed(false));
      flight.target = Point.of(0.0, 0.0, -5.0);
      flight.fly(3.0);

      assertThat(flight.aircraft.stands()).isTrue();
    }
  }
}
