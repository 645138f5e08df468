package org.u2sa.control.cascade;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.u2sa.control.Pid;

class SteadyPushTest {
  private static final double STEP_S = 0.05;

  private final Pid surge = new Pid(Pid.Gains.of(1.0, 3.0, 0.0));
  private final Pid sway = new Pid(Pid.Gains.of(1.0, 3.0, 0.0));
  private final SteadyPush push = new SteadyPush();

  @BeforeEach
  void setUp() {
    surge.disturb(2.0); // the vessel's own drag
    sway.disturb(0.5);
    ahead(20.0);
  }

  private void ahead(double seconds) {
    turn(0.0, 0.0, seconds);
  }

  private void turn(double fromRad, double toRad, double seconds) {
    int steps = (int) Math.round(seconds / STEP_S);
    for (int i = 0; i <= steps; i++) {
      double psi = fromRad + i * (toRad - fromRad) / steps;
      push.turn(surge, sway, Math.IEEEremainder(psi, 2.0 * Math.PI), i == 0 ? 0.0 : STEP_S);
    }
  }

  @Test
  void turn_halfRound_reversesThePushFromAbeamOnly() {
    turn(0.0, Math.PI, 6.0);

    assertThat(sway.integral()).isCloseTo(-0.5, within(0.1));
    assertThat(surge.integral()).isCloseTo(2.0, within(0.1));
  }

  @Test
  void turn_quarterRoundToTheRight_pushFromTheRightIsNowFromAhead() {
    turn(0.0, Math.PI / 2, 3.0);

    assertThat(sway.integral()).isCloseTo(0.0, within(0.1));
    assertThat(surge.integral()).isCloseTo(2.5, within(0.1));
  }

  @Test
  void turn_afterAGap_changesNothing() {
    push.turn(surge, sway, Math.PI, 5.0);

    assertThat(sway.integral()).isEqualTo(0.5);
    assertThat(surge.integral()).isEqualTo(2.0);
  }

  @Test
  void turn_integralOfTheTurnItself_isNotTakenForAPush() {
    push.rest();
    for (int i = 0; i < 400; i++) {
      push.turn(surge, sway, Math.IEEEremainder(0.4 * i * STEP_S, 2.0 * Math.PI), STEP_S);
    }

    assertThat(sway.integral()).isEqualTo(0.5);
    assertThat(surge.integral()).isEqualTo(2.0);
  }
}
