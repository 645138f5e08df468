package org.u2sa.sim.aircraft;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.sim.atmosphere.StandardAtmosphere;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.sim.motion.BodyAttitude;

class FlightDynamicsTest {
  private final FlightDynamics dynamics = new FlightDynamics(new PistonEngine(false));
  private final double[] state = new double[FlightDynamics.SIZE];
  private final double[] rate = new double[FlightDynamics.SIZE];

  @Test
  void derivatives_at45Degrees_moveOverTheWgs84Ellipsoid() {
    // radii of curvature at 45°: meridian 6,367,381.816 m, prime vertical 6,388,838.290 m (NIMA
    // TR8350.2)
    state[FlightDynamics.LAT] = Math.toRadians(45.0);
    state[FlightDynamics.VN] = 50.0;
    state[FlightDynamics.VE] = 30.0;
    derive(0.0, 0.0, 0.3);
    assertThat(50.0 / rate[FlightDynamics.LAT]).isCloseTo(6_367_381.816, within(0.01));
    assertThat(30.0 / rate[FlightDynamics.LON] / Math.cos(Math.toRadians(45.0)))
        .isCloseTo(6_388_838.290, within(0.01));
  }

  @Test
  void derivatives_eastwardsWithoutRotation_headingFollowsTheGreatCircle() {
    // ψ' = VE tan φ / N: straight on is a great circle, whose bearing grows going east in the north
    state[FlightDynamics.LAT] = Math.toRadians(60.0);
    state[FlightDynamics.VE] = 60.0;
    derive(0.0, 0.0, Math.PI / 2);
    double before = dynamics.attitude.headingRad();
    for (int i = FlightDynamics.Q0; i < FlightDynamics.Q0 + 4; i++) {
      state[i] += 100.0 * rate[i];
    }
    dynamics.attitude.set(state[6], state[7], state[8], state[9]);
    double turned = (dynamics.attitude.headingRad() - before) / 100.0;
    double prime = 6_378_137.0 / Math.sqrt(1.0 - 6.69437999014e-3 * 0.75);
    assertThat(turned).isCloseTo(60.0 * Math.tan(Math.toRadians(60.0)) / prime, within(1e-9));
  }

  @Test
  void derivatives_withoutAir_velocityTurnsWithTheVerticalAndKeepsItsLength() {
    state[FlightDynamics.LAT] = Math.toRadians(60.0);
    state[FlightDynamics.VN] = 40.0;
    state[FlightDynamics.VE] = 60.0;
    state[FlightDynamics.VD] = 5.0;
    dynamics.densityKgPerM3 = 0.0;
    derive(0.0, 0.0, 0.3);
    double along =
        40.0 * rate[FlightDynamics.VN]
            + 60.0 * rate[FlightDynamics.VE]
            + 5.0 * (rate[FlightDynamics.VD] - Gravity.STANDARD_MPS2);
    assertThat(along).isCloseTo(0.0, within(1e-9));
    // Stevens and Lewis, 2nd ed., eq. 1.4-16 without the earth's rotation: VE' = VE (VN tan φ − VD)
    // / N
    double prime = 6_378_137.0 / Math.sqrt(1.0 - 6.69437999014e-3 * 0.75);
    double expected = 60.0 * (40.0 * Math.tan(Math.toRadians(60.0)) + 5.0) / prime;
    assertThat(rate[FlightDynamics.VE]).isCloseTo(expected, within(1e-9));
  }

  @Test
  void derivatives_atRestInTheAir_fallsAtG() {
    state[FlightDynamics.ALT] = 1_000.0;
    derive(0.2, 0.3, 0.4);
    assertThat(rate[FlightDynamics.VD]).isEqualTo(Gravity.STANDARD_MPS2);
    assertThat(rate[FlightDynamics.VN]).isZero();
  }

  @Test
  void attitude_written_isReadBack() {
    derive(-0.7, 0.4, 5.0);
    assertThat(dynamics.attitude.rollRad()).isCloseTo(-0.7, within(1e-12));
    assertThat(dynamics.attitude.pitchRad()).isCloseTo(0.4, within(1e-12));
    assertThat(dynamics.attitude.headingRad()).isCloseTo(5.0, within(1e-12));
  }

  @Test
  void step_glideWithoutEngine_energyOnlyFalls() {
    Trim trim = Trim.atThrottle(2_000.0, 40.0, 0.0, 0.0);
    FlightStart start = trim.start(0, 0, 0, 0);
    Cessna172 aircraft = Cessna172.inFlight(start, Wind.calm());
    ControlInputs cutOff = trim.controls().withMixture(0.0);
    aircraft.step(cutOff, 5.0);
    double energy = energy(aircraft.state());
    for (int i = 0; i < 100; i++) {
      double pull = i % 20 < 3 ? -0.1 : 0.0; // swings the phugoid: height and speed trade
      aircraft.step(cutOff.withSurfaces(0.0, cutOff.elevator() + pull, 0.0), 0.5);
      double now = energy(aircraft.state());
      assertThat(now).isLessThan(energy);
      energy = now;
    }
  }

  @Test
  void step_levelThrottle_powerBalancesTheEnergysRate() {
    Trim trim = Trim.atThrottle(500.0, 45.0, 0.9, 0.0);
    Cessna172 aircraft = Cessna172.inFlight(trim.start(0, 0, 0, 0), Wind.calm());
    double before = energy(aircraft.state());
    aircraft.step(trim.controls(), 1.0);
    double gained = energy(aircraft.state()) - before;
    Propeller propeller = new Propeller();
    Air air = new Air(trim);
    propeller.compute(
        trim.engineRpm() * PistonEngine.RADPERS_PER_RPM,
        45.0 * Math.cos(trim.angleOfAttackRad()),
        air.density);
    double drag = 0.5 * air.density * 45.0 * 45.0 * Airframe.WING_AREA_M2 * air.dragCoefficient;
    assertThat(gained).isCloseTo((propeller.thrustN() - drag) * 45.0, within(3_000.0));
  }

  /** The polar of the book, written out apart from the code under test. */
  private static final class Air {
    final double density;
    final double dragCoefficient;

    Air(Trim trim) {
      density = StandardAtmosphere.at(trim.altitudeM()).densityKgPerM3();
      double lift = 0.31 + 4.6 * trim.angleOfAttackRad();
      dragCoefficient = 0.0319 + lift * lift * 0.0582;
    }
  }

  private static double energy(AircraftMotion s) {
    double v2 =
        s.velocityNorthMps() * s.velocityNorthMps()
            + s.velocityEastMps() * s.velocityEastMps()
            + s.velocityDownMps() * s.velocityDownMps();
    return Airframe.MASS_KG * (Gravity.STANDARD_MPS2 * s.altitudeM() + 0.5 * v2);
  }

  private void derive(double roll, double pitch, double heading) {
    dynamics.groundM = -10_000.0;
    BodyAttitude.write(state, FlightDynamics.Q0, roll, pitch, heading);
    dynamics.derivatives(state, rate);
  }
}
