package org.u2sa.sim.aircraft;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.sim.atmosphere.Wind;

class StallTest {
  private static final double KNOT = 1852.0 / 3600.0;

  // Cessna 172P handbook, section 5, stall speeds, power off, bank 0: 51 KCAS flaps up, 46 KCAS
  // flaps 30°
  @ParameterizedTest
  @CsvSource({"0.0, 49.0, 53.5", "1.0, 44.0, 48.5"})
  void step_stickSlowlyBack_stallsNearTheHandbooksSpeed(double flaps, double low, double high) {
    Cessna172 aircraft = gliding(flaps);
    double slowest = Double.MAX_VALUE;
    double stick = Trim.atThrottle(1_500.0, 35.0, 0.0, flaps).controls().elevator();
    while (!aircraft.state().stalled() && aircraft.state().timeS() < 60.0) {
      slowest = Math.min(slowest, aircraft.state().calibratedAirspeedMps());
      stick -= 0.02 * 0.05;
      hold(aircraft, stick, flaps);
    }
    assertThat(aircraft.state().stalled()).isTrue();
    assertThat(slowest / KNOT).isBetween(low, high);
  }

  @Test
  void step_stickForward_recoversWithinAFewSeconds() {
    Cessna172 aircraft = gliding(0.0);
    while (!aircraft.state().stalled() && aircraft.state().timeS() < 30.0) {
      hold(aircraft, -0.6, 0.0);
    }
    assertThat(aircraft.state().stalled()).isTrue();
    for (int i = 0; i < 60; i++) {
      hold(aircraft, 0.1, 0.0);
    }
    assertThat(aircraft.state().stalled()).isFalse();
    assertThat(aircraft.state().calibratedAirspeedMps() / KNOT).isGreaterThan(55.0);
  }

  @Test
  void compute_pastTheStall_liftFallsAndDragRises() {
    assertThat(lift(20.0)).isLessThan(0.85 * lift(16.5));
    assertThat(drag(22.0)).isGreaterThan(1.3 * drag(16.0));
  }

  @Test
  void compute_pastTheStall_rollIsNoLongerDamped() {
    assertThat(rollMoment(5.0, 0.02) - rollMoment(5.0, 0.0)).isNegative();
    assertThat(rollMoment(22.0, 0.02) - rollMoment(22.0, 0.0)).isPositive();
    assertThat(rollMoment(22.0, 2.0) - rollMoment(22.0, 0.0)).isNegative(); // so it cannot wind up
  }

  @Test
  void stalled_onTheGround_isFalse() {
    Cessna172 aircraft =
        Cessna172.onRunway(
            new RunwayStart(0, 0, 0, 0), Wind.constant(Math.toRadians(180.0), 15.0), false);
    aircraft.step(ControlInputs.neutral().withBrakes(1.0, 1.0), 1.0);
    assertThat(aircraft.state().stalled()).isFalse();
  }

  private static Cessna172 gliding(double flaps) {
    Trim trim = Trim.atThrottle(1_500.0, 35.0, 0.0, flaps);
    return Cessna172.inFlight(trim.start(0, 0, 0, 0), Wind.calm());
  }

  private static void hold(Cessna172 aircraft, double stick, double flaps) {
    AircraftMotion state = aircraft.state();
    aircraft.step(
        ControlInputs.limited(
            -2.0 * state.rollRad() - 0.5 * state.rollRateRadPerS(),
            stick,
            -state.yawRateRadPerS(),
            0.0,
            1.0,
            flaps,
            0.0,
            0.0),
        0.05);
  }

  private static Aerodynamics at(double alphaDeg, double rollAlongFlow) {
    Aerodynamics aero = new Aerodynamics();
    aero.set(ControlInputs.neutral(), 0.0);
    double alpha = Math.toRadians(alphaDeg);
    aero.compute(
        30.0 * Math.cos(alpha),
        0.0,
        30.0 * Math.sin(alpha),
        rollAlongFlow * Math.cos(alpha),
        0.0,
        rollAlongFlow * Math.sin(alpha),
        1.225,
        0.0,
        1_000.0);
    return aero;
  }

  private static double lift(double alphaDeg) {
    Aerodynamics aero = at(alphaDeg, 0.0);
    double alpha = Math.toRadians(alphaDeg);
    return aero.forceX * Math.sin(alpha) - aero.forceZ * Math.cos(alpha);
  }

  private static double drag(double alphaDeg) {
    Aerodynamics aero = at(alphaDeg, 0.0);
    double alpha = Math.toRadians(alphaDeg);
    return -aero.forceX * Math.cos(alpha) - aero.forceZ * Math.sin(alpha);
  }

  /** Moment about the direction of flight. */
  private static double rollMoment(double alphaDeg, double rollAlongFlow) {
    Aerodynamics aero = at(alphaDeg, rollAlongFlow);
    double alpha = Math.toRadians(alphaDeg);
    return aero.momentX * Math.cos(alpha) + aero.momentZ * Math.sin(alpha);
  }
}
