package org.u2sa.vision.lane;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class LookedGroundTest {
  private static final double HALF_RAD = Math.toRadians(45.0);

  private final LookedGround ground = new LookedGround();

  private void look(int times, LookedGround.View view) {
    for (int i = 0; i < times; i++) {
      ground.look(10.0, 20.0, 0.5 * Math.PI, 5.0, HALF_RAD, view);
    }
  }

  @Test
  void isKnown_lookedAtThrice_isTrueWithinTheSectorOnly() {
    look(3, (x, y) -> true);
    assertThat(ground.isKnown(10.0, 24.0)).as("ahead").isTrue();
    assertThat(ground.isKnown(12.0, 23.0)).as("34 degrees aside").isTrue();
    assertThat(ground.isKnown(13.0, 21.5)).as("63 degrees aside").isFalse();
    assertThat(ground.isKnown(10.0, 26.0)).as("too far").isFalse();
    assertThat(ground.isKnown(10.0, 20.5)).as("too near").isFalse();
    assertThat(ground.isKnown(10.0, 16.0)).as("behind").isFalse();
  }

  @Test
  void isKnown_lookedAtTwice_isFalse() {
    look(2, (x, y) -> true);
    assertThat(ground.isKnown(10.0, 24.0)).isFalse();
  }

  @Test
  void isKnown_hiddenBehindSomething_isFalse() {
    look(3, (x, y) -> x > 10.5);
    assertThat(ground.isKnown(10.0, 24.0)).isFalse();
    assertThat(ground.isKnown(11.5, 24.0)).isTrue();
  }

  @Test
  void clear_afterLooks_knowsNothing() {
    look(3, (x, y) -> true);
    ground.clear();
    assertThat(ground.isKnown(10.0, 24.0)).isFalse();
  }
}
