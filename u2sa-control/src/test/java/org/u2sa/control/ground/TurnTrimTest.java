package org.u2sa.control.ground;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;

class TurnTrimTest {
  private static final Drive AHEAD = new Drive(1.0, 0.0);

  @Test
  void step_feedbackSwitchedOff_forgetsTheTrim() {
    TurnTrim trim = new TurnTrim("SPEED TRIM");
    trim.step(AHEAD, OptionalDouble.of(0.2), false, 1.0, 2.0, 0.1);
    assertThat(trim.step(AHEAD, OptionalDouble.of(0.2), false, 1.0, 2.0, 0.1)).isPositive();

    assertThat(trim.step(AHEAD, OptionalDouble.of(0.2), false, 0.0, 2.0, 0.1)).isZero();
  }
}
