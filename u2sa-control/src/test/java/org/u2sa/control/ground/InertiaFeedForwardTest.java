package org.u2sa.control.ground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class InertiaFeedForwardTest {
  private static final double STEP_S = 0.02;
  private static final double LAG_S = 1.5;

  private final InertiaFeedForward inertia = new InertiaFeedForward();

  /** Farthest from what is wanted that a lagging vehicle is, which ramps up and down. */
  private double worstMps(double timeS) {
    double speed = 0.0;
    double wanted = 0.0;
    double worst = 0.0;
    for (int i = 0; i < 300; i++) {
      double change = i < 100 ? 0.8 : i < 150 ? 0.0 : -0.8;
      wanted = Math.max(0.0, wanted + change * STEP_S);
      double told = wanted + inertia.step(wanted, timeS, STEP_S);
      speed += STEP_S / LAG_S * (told - speed);
      worst = Math.max(worst, Math.abs(wanted - speed));
    }
    return worst;
  }

  @Test
  void step_lagOfTheVehicle_makesItFollowARamp() {
    assertThat(worstMps(LAG_S)).isLessThan(0.1);
  }

  @Test
  void step_lagUnknown_addsNothing() {
    assertThat(worstMps(0.0)).isGreaterThan(0.7);
    assertThat(inertia.step(1.0, 0.0, STEP_S)).isZero();
  }

  @Test
  void step_takenOverWhileMoving_addsNothingAtFirst() {
    assertThat(inertia.step(1.0, LAG_S, STEP_S)).isZero();
    assertThat(inertia.step(1.0, LAG_S, STEP_S)).isZero();
  }

  @Test
  void step_jumpThatStays_isOverAfterTheSmoothing() {
    inertia.step(0.0, LAG_S, STEP_S);
    assertThat(inertia.step(0.1, LAG_S, STEP_S)).isBetween(0.5, 1.5);
    for (int i = 0; i < 50; i++) {
      inertia.step(0.1, LAG_S, STEP_S);
    }
    assertThat(inertia.step(0.1, LAG_S, STEP_S)).isCloseTo(0.0, within(1.0e-3));
  }
}
