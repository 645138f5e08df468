package org.u2sa.control.fixedwing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class EnergyLawTest {
  private static final double DT_S = 0.05;
  private static final double LEAST = Math.toRadians(-10.0);
  private static final double MOST = Math.toRadians(14.0);

  private final EnergyLaw law = new EnergyLaw(TestTuning.standard().energy());

  @Test
  void step_allAsWanted_changesNothing() {
    EnergyLaw.Command command = run(States.level().now(), demand(300.0, 43.0), 0.0, 100);
    assertThat(command.throttle()).isCloseTo(0.6, within(1e-9));
    assertThat(command.pitchRad()).isCloseTo(0.05, within(1e-9));
  }

  @Test
  void step_tooLow_raisesNoseAndOpensThrottle() {
    EnergyLaw.Command command = run(States.level().now(), demand(320.0, 43.0), 0.0, 20);
    assertThat(command.throttle()).isGreaterThan(0.65);
    assertThat(command.pitchRad()).isGreaterThan(0.06);
  }

  @Test
  void step_tooSlow_lowersNoseAndOpensThrottle() {
    EnergyLaw.Command command = run(States.level().now(), demand(300.0, 47.0), 0.0, 20);
    assertThat(command.throttle()).isGreaterThan(0.65);
    assertThat(command.pitchRad()).isLessThan(0.05);
  }

  @Test
  void step_tooLowAndTooFastByTheSameEnergyRate_movesPitchAndLeavesThrottle() {
    EnergyLaw.Variables p = TestTuning.standard().energy();
    double climb = 1.0; // demanded climb that equals the demanded loss of speed in energy
    double up = climb * p.altitudeTimeConstant();
    double slower = climb / 43.0 * 9.80665 * p.speedTimeConstant();
    EnergyLaw.Command command =
        run(States.level().now(), demand(300.0 + up, 43.0 - slower), 0.0, 40);
    assertThat(command.throttle()).isCloseTo(0.6, within(0.05));
    assertThat(command.pitchRad()).isGreaterThan(0.07);
  }

  @Test
  void step_farTooLowAtTheLeastSpeed_pitchServesTheSpeedAtFullThrottle() {
    EnergyLaw.Command command =
        run(States.level().speed(31.0).now(), demand(500.0, 36.0), 1.0, 100);
    assertThat(command.throttle()).isEqualTo(1.0);
    assertThat(command.pitchRad()).isLessThan(0.05);
  }

  @Test
  void step_longOutOfReach_pitchLeavesItsLimitSoonAfterTheErrorTurns() {
    run(States.level().now(), demand(900.0, 43.0), 0.0, 4000);
    EnergyLaw.Command high = run(States.level().now(), demand(900.0, 43.0), 0.0, 1);
    assertThat(high.pitchRad()).isCloseTo(MOST, within(1e-3));
    EnergyLaw.Command after = run(States.level().now(), demand(250.0, 43.0), 0.0, 200);
    assertThat(after.pitchRad()).isLessThan(Math.toRadians(8.0));
    assertThat(after.throttle()).isLessThan(0.9);
  }

  @Test
  void step_bank_addsThrottleForTheTurnsDrag() {
    FlightState turning = States.level().roll(Math.toRadians(28.0)).now();
    assertThat(run(turning, demand(300.0, 43.0), 0.0, 40).throttle()).isGreaterThan(0.61);
  }

  @Test
  void step_throttle_movesNoFasterThanItsRate() {
    double before = run(States.level().now(), demand(300.0, 43.0), 0.0, 1).throttle();
    double after = run(States.level().now(), demand(600.0, 60.0), 0.0, 1).throttle();
    double rate = TestTuning.standard().energy().throttleRateLimit();
    assertThat(after - before).isBetween(0.0, rate * DT_S + 1e-12);
  }

  @Test
  void arrest_inADescentToNowhere_demandsLevelFlightAtThePullUp() {
    FlightState sinking = States.level().climb(-7.0).pitch(-0.15).now();
    law.restart(sinking, -0.15, 0.6);
    law.arrest();
    run(sinking, demand(300.0, 43.0), 0.0, 20);
    assertThat(law.climbDemandMps()).isCloseTo(-2.0, within(1e-9)); // 1 s of 5 m/s²
    EnergyLaw.Command command = run(sinking, demand(300.0, 43.0), 0.0, 20);

    assertThat(law.climbDemandMps()).isZero();
    assertThat(command.pitchRad()).isGreaterThan(0.05);
    assertThat(command.throttle()).isGreaterThan(0.6);
  }

  @Test
  void arrest_sinksFasterThanAllowedToALowerAltitude_demandsTheSinkLimitAtOnce() {
    FlightState sinking = States.level().climb(-7.0).pitch(-0.15).now();
    law.restart(sinking, -0.15, 0.6);
    law.arrest();
    run(sinking, demand(100.0, 43.0), 0.0, 20);

    assertThat(law.climbDemandMps())
        .isCloseTo(-TestTuning.standard().energy().sinkLimit(), within(1e-9));
  }

  @Test
  void arrest_climbsFarBeyondTheDemandedAltitude_demandsLevelFlightSoon() {
    FlightState climbing = States.level().climb(8.0).pitch(0.2).now();
    law.restart(climbing, 0.2, 0.6);
    law.arrest();
    run(climbing, demand(300.0, 43.0), 0.0, 40);

    assertThat(law.climbDemandMps()).isZero();
  }

  @Test
  void arrest_descentThatLeadsToTheDemandedAltitude_changesNothing() {
    FlightState sinking = States.level().climb(-3.0).pitch(-0.02).now();
    EnergyLaw usual = new EnergyLaw(TestTuning.standard().energy());
    usual.restart(sinking, -0.02, 0.4);
    law.restart(sinking, -0.02, 0.4);
    law.arrest();

    for (int i = 0; i < 20; i++) {
      EnergyLaw.Command expected = usual.step(sinking, demand(288.0, 43.0), 0.0, DT_S);
      assertThat(law.step(sinking, demand(288.0, 43.0), 0.0, DT_S)).isEqualTo(expected);
    }
  }

  @Test
  void arrest_atTheLeastSpeed_pitchServesTheSpeed() {
    FlightState sinking = States.level().speed(31.0).climb(-7.0).pitch(-0.1).now();
    law.restart(sinking, -0.1, 0.6);
    law.arrest();
    EnergyLaw.Command command = run(sinking, demand(300.0, 40.0), 1.0, 40);

    assertThat(command.pitchRad()).isLessThan(0.0);
    assertThat(command.throttle()).isEqualTo(1.0);
  }

  private EnergyLaw.Command run(
      FlightState state, EnergyLaw.Demand demand, double urgency, int steps) {
    EnergyLaw.Command command = null;
    for (int i = 0; i < steps; i++) {
      command = law.step(state, demand, urgency, DT_S);
    }
    return command;
  }

  private static EnergyLaw.Demand demand(double altitudeM, double airspeedMps) {
    return new EnergyLaw.Demand(altitudeM, airspeedMps, EnergyLaw.Priority.BOTH, LEAST, MOST, 5.0);
  }
}
