package org.u2sa.control.cascade;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Point;

class DriftTest {
  private final Drift drift = new Drift();

  private void go(double forward, double right, double turnRadps, double seconds) {
    for (double t = 0.0; t < seconds; t += 0.1) {
      drift.step(Point.of(forward, right, 0.0), turnRadps, 0.1);
    }
  }

  @Test
  void rad_steadyDriftToTheRight_isTheAngleOfTheCourse() {
    go(1.0, 0.5, 0.0, 30.0);

    assertThat(drift.rad()).isCloseTo(Math.atan2(0.5, 1.0), within(0.001));
  }

  @Test
  void rad_slipOfAFastTurn_isHardlyLearnt() {
    go(1.0, 0.5, 1.0, 2.0);

    assertThat(drift.rad()).isBetween(0.0, 0.05);
  }

  @Test
  void rad_sternwayInACurrent_staysWithinItsLimit() {
    go(-1.0, 5.0, 0.0, 60.0);

    assertThat(Math.toDegrees(drift.rad())).isCloseTo(50.0, within(0.1));
  }
}
