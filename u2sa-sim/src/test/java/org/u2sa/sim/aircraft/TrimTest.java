package org.u2sa.sim.aircraft;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.sim.atmosphere.StandardAtmosphere;
import org.u2sa.sim.atmosphere.Wind;

class TrimTest {
  private static final double KNOT = 1852.0 / 3600.0;

  @ParameterizedTest
  @ValueSource(doubles = {33.0, 40.0, 50.0, 60.0})
  void level_flownHandsOff_staysWhereItIs(double speedMps) {
    Trim trim = Trim.level(600.0, speedMps, 0.0);
    Cessna172 aircraft = Cessna172.inFlight(trim.start(10.0, 47.0, 0.0, 1.0), Wind.calm());
    aircraft.step(trim.controls(), 30.0);
    AircraftMotion state = aircraft.state();
    assertThat(state.altitudeM()).isCloseTo(600.0, within(0.5));
    assertThat(state.trueAirspeedMps()).isCloseTo(speedMps, within(0.05));
    assertThat(state.rollRad()).isCloseTo(0.0, within(0.01));
    assertThat(state.loadFactor()).isCloseTo(1.0, within(0.02));
    assertThat(state.engineRpm()).isCloseTo(trim.engineRpm(), within(1.0));
  }

  @Test
  void level_lift_carriesTheWeight() {
    Trim trim = Trim.level(0.0, 55.0, 0.0);
    Aerodynamics aero = new Aerodynamics();
    aero.set(trim.controls(), 0.0);
    double alpha = trim.angleOfAttackRad();
    aero.compute(55.0 * Math.cos(alpha), 0.0, 55.0 * Math.sin(alpha), 0, 0, 0, 1.225, 0.0, 1_000.0);
    double lift = aero.forceX * Math.sin(alpha) - aero.forceZ * Math.cos(alpha);
    assertThat(lift).isCloseTo(Airframe.MASS_KG * Gravity.STANDARD_MPS2, within(300.0));
  }

  @Test
  void atThrottle_full_isAsFastAtSeaLevelAsTheHandbook() {
    // Cessna 172P handbook, front page: maximum speed at sea level 123 knots
    assertThat(Trim.atThrottle(0.0, 119.0 * KNOT, 1.0, 0.0).climbMps()).isPositive();
    assertThat(Trim.atThrottle(0.0, 128.0 * KNOT, 1.0, 0.0).climbMps()).isNegative();
  }

  @Test
  void level_cruise_needsThePowerOfTheHandbook() {
    // Handbook, front page: 120 knots at 8000 ft with 75 %, mixture leaned; here full rich at 115
    // knots
    double altitude = 8_000.0 * 0.3048;
    double watt = Trim.level(altitude, 115.0 * KNOT, 0.0).shaftPowerW();
    assertThat(watt / (160.0 * 745.7) * 100.0).isBetween(66.0, 74.0);
  }

  @Test
  void atThrottle_full_climbsLikeTheHandbook() {
    // Handbook: 700 ft/min at sea level and 76 KIAS; service ceiling (100 ft/min) 13,000 ft
    Trim low = Trim.atThrottle(0.0, 76.0 * KNOT, 1.0, 0.0);
    assertThat(low.climbMps() / 0.3048 * 60.0).isBetween(650.0, 770.0);
    double ceiling = 13_000.0 * 0.3048;
    double tas = StandardAtmosphere.at(ceiling).trueAirspeedMps(70.0 * KNOT);
    assertThat(Trim.atThrottle(ceiling, tas, 1.0, 0.0).climbMps() / 0.3048 * 60.0)
        .isBetween(0.0, 250.0);
  }

  @Test
  void atThrottle_idle_glidesLikeTheHandbook() {
    // Handbook, maximum glide: 1.5 nautical miles for 1000 ft at 65 KIAS: 9 to 1
    Trim glide = Trim.atThrottle(500.0, 66.0 * KNOT, 0.0, 0.0);
    assertThat(-1.0 / Math.tan(glide.flightPathRad())).isBetween(8.5, 10.5);
  }

  @Test
  void level_flaps_lowerTheNose() {
    assertThat(Trim.level(0.0, 35.0, 1.0).pitchRad())
        .isLessThan(Trim.level(0.0, 35.0, 0.0).pitchRad() - Math.toRadians(2.0));
  }

  @Test
  void turning_bank_needsMorePowerAndLittleRudder() {
    Trim turn = Trim.turning(500.0, 50.0, Math.toRadians(30.0));
    Trim straight = Trim.level(500.0, 50.0, 0.0);
    assertThat(turn.shaftPowerW()).isGreaterThan(1.03 * straight.shaftPowerW());
    assertThat(Math.abs(turn.controls().rudder())).isLessThan(0.2);
    assertThat(Math.abs(turn.sideslipRad())).isLessThan(Math.toRadians(2.0));
  }

  @Test
  void level_tooSlow_isRefusedWithItsNumbers() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Trim.level(0.0, 20.0, 0.0))
        .withMessageContaining("no steady flight at 20.0 m/s");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Trim.level(Double.NaN, 50.0, 0.0))
        .withMessageContaining("trim altitude [m]: NaN");
  }
}
