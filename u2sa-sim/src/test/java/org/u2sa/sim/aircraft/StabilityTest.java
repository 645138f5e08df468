package org.u2sa.sim.aircraft;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.sim.atmosphere.Wind;

class StabilityTest {
  private static final double SPEED = 52.0;
  private final Trim trim = Trim.level(1_000.0, SPEED, 0.0);
  private final Cessna172 aircraft = Cessna172.inFlight(trim.start(0, 0, 0, 0), Wind.calm());

  @Test
  void step_elevatorStep_shortPeriodOvershootsLittle() {
    // 2ζω = −(Mq + Mα' + Zα/V) = 7.0 /s and ω = 5.0 /s at 52 m/s: ζ = 0.7, overshoot 5 % (Nelson,
    // Flight Stability, eq. 4.75)
    double before = aircraft.state().angleOfAttackRad();
    double highest = 0.0;
    for (int i = 0; i < 60; i++) {
      deflect(0.0, -0.03, 0.0, 1.0 / 60.0);
      highest = Math.max(highest, aircraft.state().angleOfAttackRad());
    }
    deflect(0.0, -0.03, 0.0, 0.4); // where a weakly damped one would swing back
    double settled = aircraft.state().angleOfAttackRad() - before;
    assertThat(settled).isBetween(Math.toRadians(0.5), Math.toRadians(2.0));
    assertThat((highest - before) / settled).isBetween(0.97, 1.12);
  }

  @Test
  void step_elevatorPulse_phugoidIsSlowAndDamped() {
    deflect(0.0, -0.06, 0.0, 2.0);
    double first = speedSwing(60.0);
    double second = speedSwing(60.0);
    assertThat(first).isGreaterThan(2.0);
    assertThat(second).isLessThan(0.7 * first);
  }

  @Test
  void step_elevatorPulse_phugoidHasLanchestersPeriod() {
    deflect(0.0, -0.06, 0.0, 2.0);
    double start = 0.0;
    double period = 0.0;
    boolean climbing = aircraft.state().velocityDownMps() < 0.0;
    while (period == 0.0 && aircraft.state().timeS() < 120.0) {
      aircraft.step(trim.controls(), 0.1);
      boolean nowClimbing = aircraft.state().velocityDownMps() < 0.0;
      if (nowClimbing && !climbing) {
        if (start > 0.0) {
          period = aircraft.state().timeS() - start;
        } else {
          start = aircraft.state().timeS();
        }
      }
      climbing = nowClimbing;
    }
    // Lanchester: T = π √2 V / g = 23.6 s at 52 m/s; real ones are longer by a third for damping
    // and pitch stiffness
    assertThat(period).isBetween(23.0, 34.0);
  }

  @Test
  void step_rudderPulse_dutchRollDiesOut() {
    deflect(0.0, 0.0, 0.3, 1.0);
    double first = sideslipSwing(3.0);
    aircraft.step(trim.controls(), 3.0);
    double later = sideslipSwing(3.0);
    assertThat(first).isGreaterThan(Math.toRadians(2.0));
    assertThat(later).isLessThan(0.2 * first);
  }

  @Test
  void step_smallBank_spiralIsNearNeutral() {
    while (aircraft.state().rollRad() < Math.toRadians(10.0) && aircraft.state().timeS() < 20.0) {
      deflect(0.15, 0.0, 0.0, 0.1);
    }
    aircraft.step(trim.controls(), 20.0);
    // MIL-F-8785C, 3.3.1.3, level 1: bank doubles in no less than 12 s
    assertThat(Math.toDegrees(aircraft.state().rollRad())).isBetween(5.0, 16.0);
  }

  @Test
  void step_neutralControlsInCruise_fliesOnHandsOff() {
    Trim cruise = Trim.level(1_000.0, 59.0, 0.0);
    Cessna172 cruising = Cessna172.inFlight(cruise.start(0, 0, 0, 0), Wind.calm());
    cruising.step(ControlInputs.neutral().withThrottle(cruise.controls().throttle()), 60.0);
    assertThat(cruising.state().rollRad()).isCloseTo(0.0, within(Math.toRadians(15.0)));
    assertThat(cruising.state().altitudeM()).isCloseTo(1_000.0, within(100.0));
  }

  @Test
  void step_aileronRudderElevator_turnTheRightWay() {
    deflect(0.3, 0.0, 0.0, 0.5);
    assertThat(aircraft.state().rollRateRadPerS()).isGreaterThan(0.1);
    Cessna172 other = Cessna172.inFlight(trim.start(0, 0, 0, 0), Wind.calm());
    other.step(shifted(0.0, 0.2, 0.3), 0.3);
    assertThat(other.state().yawRateRadPerS()).isGreaterThan(0.05);
    assertThat(other.state().pitchRateRadPerS()).isLessThan(-0.05);
  }

  @Test
  void step_rollAt30Degrees_turnsAtGTanPhiOverV() {
    double bank = Math.toRadians(30.0);
    Trim turn = Trim.turning(1_000.0, SPEED, bank);
    Cessna172 turning = Cessna172.inFlight(turn.start(0, 0, 0, 0), Wind.calm());
    double turned = 0.0;
    double expected = 0.0;
    while (turning.state().timeS() < 40.0) {
      AircraftMotion before = turning.state();
      double elevator =
          turn.controls().elevator()
              - 0.02 * before.velocityDownMps()
              + 0.005 * (before.altitudeM() - 1_000.0);
      turning.step(
          ControlInputs.limited(
              turn.controls().aileron()
                  + 2.0 * (bank - before.rollRad())
                  - 0.5 * before.rollRateRadPerS(),
              elevator,
              turn.controls().rudder() + 2.0 * before.sideslipRad(),
              turn.controls().throttle(),
              1.0,
              0.0,
              0.0,
              0.0),
          0.025);
      AircraftMotion after = turning.state();
      if (after.timeS() > 15.0) {
        turned += Math.IEEEremainder(after.headingRad() - before.headingRad(), 2.0 * Math.PI);
        expected +=
            0.025 * Gravity.STANDARD_MPS2 * Math.tan(after.rollRad()) / after.trueAirspeedMps();
      }
    }
    assertThat(turned).isCloseTo(expected, within(0.04 * expected));
    assertThat(turning.state().altitudeM()).isCloseTo(1_000.0, within(15.0));
  }

  private ControlInputs shifted(double aileron, double elevator, double rudder) {
    ControlInputs c = trim.controls();
    return c.withSurfaces(c.aileron() + aileron, c.elevator() + elevator, c.rudder() + rudder);
  }

  private void deflect(double aileron, double elevator, double rudder, double seconds) {
    aircraft.step(shifted(aileron, elevator, rudder), seconds);
  }

  private double speedSwing(double seconds) {
    double low = Double.MAX_VALUE;
    double high = 0.0;
    for (double t = 0.0; t < seconds; t += 0.5) {
      aircraft.step(trim.controls(), 0.5);
      low = Math.min(low, aircraft.state().trueAirspeedMps());
      high = Math.max(high, aircraft.state().trueAirspeedMps());
    }
    return high - low;
  }

  private double sideslipSwing(double seconds) {
    double high = 0.0;
    for (double t = 0.0; t < seconds; t += 0.05) {
      high = Math.max(high, Math.abs(aircraft.state().sideslipRad()));
      aircraft.step(trim.controls(), 0.05);
    }
    return high;
  }
}
