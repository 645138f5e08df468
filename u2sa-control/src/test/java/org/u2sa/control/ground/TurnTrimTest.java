package org.u2sa.control.ground;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class TurnTrimTest {
  private static final Drive AHEAD = new Drive(1.0, 0.0);

  /** Steps for ten seconds. */
  private static double trim(TurnTrim trim, double speedMps, double errorMps, boolean atFullPower) {
    double last = 0.0;
    for (int i = 0; i < 100; i++) {
      last =
          trim.step(
              new Drive(speedMps, 0.0), OptionalDouble.of(errorMps), atFullPower, 0.5, 2.0, 0.1);
    }
    return last;
  }

  @ParameterizedTest
  @ValueSource(doubles = {1.0, -1.0})
  void step_tooFastAtFullPower_trimIsTakenBack(double direction) {
    TurnTrim trim = new TurnTrim("SPEED TRIM");
    double wound = direction * trim(trim, direction, 0.3 * direction, false);
    assertThat(wound).isEqualTo(1.0);

    assertThat(direction * trim(trim, direction, -0.1 * direction, true)).isLessThan(0.6);
  }

  @ParameterizedTest
  @ValueSource(doubles = {1.0, -1.0})
  void step_tooSlowAtFullPower_trimDoesNotWindUp(double direction) {
    TurnTrim trim = new TurnTrim("SPEED TRIM");

    assertThat(trim(trim, direction, 0.3 * direction, true)).isZero();
  }

  @Test
  void step_changeOfDirection_forgetsTheTrim() {
    TurnTrim trim = new TurnTrim("SPEED TRIM");
    trim(trim, -1.0, -0.3, false);

    assertThat(trim.step(new Drive(1.0, 0.0), OptionalDouble.of(0.0), false, 0.5, 2.0, 0.1))
        .isZero();
  }

  @Test
  void step_feedbackSwitchedOff_forgetsTheTrim() {
    TurnTrim trim = new TurnTrim("SPEED TRIM");
    trim.step(AHEAD, OptionalDouble.of(0.2), false, 1.0, 2.0, 0.1);
    assertThat(trim.step(AHEAD, OptionalDouble.of(0.2), false, 1.0, 2.0, 0.1)).isPositive();

    assertThat(trim.step(AHEAD, OptionalDouble.of(0.2), false, 0.0, 2.0, 0.1)).isZero();
  }
}
