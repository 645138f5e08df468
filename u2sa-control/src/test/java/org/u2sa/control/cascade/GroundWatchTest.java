package org.u2sa.control.cascade;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class GroundWatchTest {
  private static final double STEP_S = 0.02;

  private final GroundWatch ground = new GroundWatch();

  private void step(double seconds, double toGoDownM, double downMps, boolean isOnSide) {
    for (int i = 0; i < seconds / STEP_S; i++) {
      ground.step(toGoDownM, 0.0, downMps, 0.0, isOnSide, STEP_S);
    }
  }

  @Test
  void step_onItsSideAtRest_stands() {
    ground.flies();

    step(1.2, 0.0, 0.0, true);

    assertThat(ground.stands()).isTrue();
  }

  @Test
  void step_onItsSideWhileFalling_flies() {
    ground.flies();

    step(1.2, 0.0, 4.0, true);

    assertThat(ground.stands()).isFalse();
  }

  @Test
  void step_standingOnItsSideWithTargetAbove_doesNotTakeOff() {
    step(1.0, -5.0, 0.0, true);

    assertThat(ground.stands()).isTrue();
  }

  @Test
  void step_standingWhenThrownOnItsSide_doesNotTakeOff() {
    step(1.0, 1.0, 2.0, true);

    assertThat(ground.stands()).isTrue();
  }
}
