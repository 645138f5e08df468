package org.u2sa.estimation.delay;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

/** A vehicle that accelerates steadily. */
class InertialPathTest {
  private final double[] path = new double[InertialPath.SIZE];
  private final double[] since = new double[6];

  private void accelerate(double north, double down, double seconds) {
    for (int i = 1; i <= Math.round(seconds * 100.0); i++) {
      InertialPath.advance(path, 50.0 + 0.01 * i, 0.01, north, 0.0, down);
    }
  }

  @Test
  void since_steadyAcceleration_isChangeAndWayOfIt() {
    accelerate(2.0, -1.0, 3.0);
    assertThat(InertialPath.since(path, 0.5, since)).isTrue();
    assertThat(since[0]).isCloseTo(1.0, within(1e-6));
    assertThat(since[2]).isCloseTo(-0.5, within(1e-6));
    assertThat(since[3]).isCloseTo(-0.25, within(1e-3)); // slower before: v τ - a τ²/2
    assertThat(since[5]).isCloseTo(0.125, within(1e-3));
  }

  @Test
  void since_beforeItsBeginning_isUnknown() {
    accelerate(2.0, 0.0, 0.4);
    assertThat(InertialPath.since(path, 0.5, since)).isFalse();
  }

  @Test
  void since_restarted_isUnknown() {
    accelerate(2.0, 0.0, 2.0);
    InertialPath.restart(path);
    assertThat(InertialPath.since(path, 0.1, since)).isFalse();
  }

  @Test
  void since_headingCorrected_turnsWithIt() {
    accelerate(2.0, 0.0, 2.0);
    InertialPath.corrected(path, Math.PI / 2.0);
    assertThat(InertialPath.since(path, 0.5, since)).isTrue();
    assertThat(since[0]).isCloseTo(0.0, within(1e-6));
    assertThat(since[1]).isCloseTo(1.0, within(1e-6));
  }
}
