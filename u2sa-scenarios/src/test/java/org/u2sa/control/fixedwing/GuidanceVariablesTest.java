package org.u2sa.control.fixedwing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class GuidanceVariablesTest {
  private final GuidanceVariables guard = TestTuning.standard().guidance();

  @Test
  void leastSpeed_bankOf60Degrees_growsWithTheRootOfLoadFactorTwo() {
    assertThat(guard.leastSpeedMps(0.0)).isCloseTo(31.44, within(1e-9));
    assertThat(guard.leastSpeedMps(Math.toRadians(60.0)))
        .isCloseTo(31.44 * Math.sqrt(2.0), within(1e-9));
  }

  @Test
  void bankLimit_atTheBanksOwnLeastSpeed_isThatBank() {
    double bank = Math.toRadians(40.0);
    FlightState state = States.level().speed(guard.leastSpeedMps(bank)).now();
    assertThat(guard.bankLimitRad(state)).isCloseTo(bank, within(1e-9));
  }

  @Test
  void bankLimit_slow_isNone() {
    assertThat(guard.bankLimitRad(States.level().speed(28.0).now())).isZero();
  }

  @Test
  void urgency_growsFromNoneToOneAcrossTheBand() {
    assertThat(guard.urgency(States.level().speed(43.0).now())).isZero();
    assertThat(guard.urgency(States.level().speed(33.44).now())).isCloseTo(0.5, within(1e-9));
    assertThat(guard.urgency(States.level().speed(29.0).now())).isEqualTo(1.0);
  }

  @Test
  void pitchLimit_angleOfAttackPastItsLimit_isBelowThePresentPitch() {
    FlightState mushing = States.level().pitch(0.2).alpha(Math.toRadians(15.0)).now();
    assertThat(guard.pitchLimitRad(mushing)).isCloseTo(0.2 - Math.toRadians(3.0), within(1e-9));
  }

  @Test
  void pullUp_slowFastAndBanked_isWhatLiftAndLoadLeave() {
    double least = guard.leastSpeedMps(0.0);
    assertThat(guard.pullUpMps2(States.level().speed(least).now())).isZero();
    assertThat(guard.pullUpMps2(States.level().speed(1.2 * least).now()))
        .isCloseTo(0.44 * 9.80665, within(1e-9));
    assertThat(guard.pullUpMps2(States.level().speed(2.0 * least).now()))
        .isCloseTo(0.7 * 9.80665, within(1e-9));
    FlightState banked = States.level().speed(2.0 * least).roll(Math.toRadians(60.0)).now();
    assertThat(guard.pullUpMps2(banked)).isZero();
  }
}
