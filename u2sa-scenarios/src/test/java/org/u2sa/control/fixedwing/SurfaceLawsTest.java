package org.u2sa.control.fixedwing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

/** Signs, scaling, limits and anti-windup of the loops that move the surfaces. */
class SurfaceLawsTest {
  private static final double DT_S = 0.05;
  private static final RateLoop.Gains GAINS = new RateLoop.Gains(0.5, 0.25, 0.8, 0.4);

  private final RollLaw roll = new RollLaw(new RollLaw.Variables(0.8, 20.0, 0.5, 0.25, 0.8, 0.4));
  private final PitchLaw pitch =
      new PitchLaw(new PitchLaw.Variables(0.8, 10.0, 0.5, 0.25, 0.8, 0.4));
  private final YawLaw yaw = new YawLaw(new YawLaw.Variables(0.5, 0.8, 0.4, 0.5, 0.45));

  @Test
  void aileron_bankWantedToTheRight_isPositive() {
    assertThat(roll.aileron(States.level().now(), 0.3, 1.0, DT_S)).isPositive();
    assertThat(roll.aileron(States.level().roll(0.5).now(), 0.3, 1.0, DT_S)).isNegative();
  }

  @Test
  void elevator_noseWantedUp_isNegative() {
    assertThat(pitch.elevator(States.level().pitch(0.0).now(), 0.1, 1.0, DT_S)).isNegative();
    assertThat(pitch.elevator(States.level().pitch(0.2).now(), 0.1, 1.0, DT_S)).isPositive();
  }

  @Test
  void elevator_inATurnAtTheWantedPitch_pullsForTheTurnsPitchRate() {
    FlightState turning = States.level().roll(Math.toRadians(25.0)).now();
    double bank = Math.toRadians(25.0);
    assertThat(PitchLaw.turnRate(turning))
        .isCloseTo(9.80665 / 43.0 * Math.sin(bank) * Math.tan(bank), within(1e-12));
    assertThat(pitch.elevator(turning, turning.pitchRad(), 1.0, DT_S)).isNegative();
  }

  @Test
  void rudder_noseSwingsRightInLevelFlight_isLeft() {
    assertThat(yaw.rudder(States.level().rates(0.0, 0.0, 0.2).now(), 0.0, 1.0, DT_S)).isNegative();
  }

  @Test
  void rudder_coordinatedRightTurn_isNone() {
    double bank = Math.toRadians(25.0);
    double rate = 9.80665 / 43.0 * Math.sin(bank) * Math.cos(0.05);
    FlightState turning = States.level().roll(bank).rates(0.0, 0.0, rate).now();
    assertThat(yaw.rudder(turning, 0.0, 1.0, DT_S)).isCloseTo(0.0, within(1e-9));
  }

  @Test
  void rudder_airFromTheRight_turnsIntoIt() {
    assertThat(yaw.rudder(States.level().beta(0.1).now(), 0.0, 1.0, DT_S)).isPositive();
  }

  @Test
  void rudder_lastingSideslip_integratesToItsLimitAndNoFurther() {
    FlightState slipping = States.level().beta(0.2).now();
    double rudder = 0.0;
    for (int i = 0; i < 1000; i++) {
      rudder = yaw.rudder(slipping, 0.0, 1.0, DT_S);
    }
    assertThat(rudder).isCloseTo(0.5 + 0.8 * 0.2, within(1e-9));
  }

  @Test
  void rateLoop_halfTheReferenceSpeed_forwardTwiceAndProportionFourfold() {
    assertThat(new RateLoop("", GAINS).step(0.1, 0.1, 2.0, DT_S)).isCloseTo(0.1, within(1e-9));
    double error = 0.01;
    double expected = 0.25 * 4.0 * error + 0.8 * 4.0 * error * DT_S;
    assertThat(new RateLoop("", GAINS).step(0.0, -error, 2.0, DT_S))
        .isCloseTo(expected, within(1e-9));
  }

  @Test
  void rateLoop_longAtItsStop_leavesItAtOnceWhenTheErrorTurns() {
    RateLoop loop = new RateLoop("", new RateLoop.Gains(0.0, 1.0, 1.0, 1.0));
    for (int i = 0; i < 2000; i++) {
      assertThat(loop.step(2.0, 0.0, 1.0, DT_S)).isEqualTo(1.0);
    }
    assertThat(loop.step(0.0, 0.0, 1.0, DT_S)).isZero(); // proportion alone is past the stop
    assertThat(loop.step(-0.2, 0.0, 1.0, DT_S)).isNegative();
  }

  @Test
  void rateLoop_lastingError_integralStaysWithinItsLimit() {
    RateLoop loop = new RateLoop("", GAINS);
    for (int i = 0; i < 2000; i++) {
      loop.step(0.1, 0.0, 1.0, DT_S);
    }
    assertThat(loop.step(0.0, 0.0, 1.0, DT_S)).isCloseTo(0.4, within(1e-12));
  }
}
