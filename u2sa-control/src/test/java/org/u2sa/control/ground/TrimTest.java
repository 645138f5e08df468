package org.u2sa.control.ground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;

class TrimTest {
  private static final double MAX_MPS = 2.0;
  private static final Drive DRIVES = new Drive(1.0, 0.0);
  private static final Drive TURNS = new Drive(0.0, 0.5);

  private final TurnTrim trim = new TurnTrim("SPEED TRIM");

  private double after(double seconds, Drive demanded, OptionalDouble errorMps) {
    double answer = 0.0;
    for (int i = 0; i < seconds * 10.0; i++) {
      answer = trim.step(demanded, errorMps, false, 0.2, MAX_MPS, 0.1);
    }
    return answer;
  }

  @Test
  void step_slowerThanDemanded_demandsMoreUpToWhatTheMotorsCan() {
    assertThat(after(1.0, DRIVES, OptionalDouble.of(0.2))).isBetween(0.03, 0.05);
    assertThat(after(100.0, DRIVES, OptionalDouble.of(0.2)))
        .isCloseTo(MAX_MPS - 1.0, within(1.0e-9));
  }

  @Test
  void step_atFullPower_windsNothingUpAndStillGivesWay() {
    double before = after(1.0, DRIVES, OptionalDouble.of(0.2));

    assertThat(trim.step(DRIVES, OptionalDouble.of(0.2), true, 0.2, MAX_MPS, 0.1))
        .isEqualTo(before);
    assertThat(trim.step(DRIVES, OptionalDouble.of(-0.2), true, 0.2, MAX_MPS, 0.1))
        .isLessThan(before);
  }

  @Test
  void step_downhill_mayReverseTheMotors() {
    assertThat(after(100.0, DRIVES, OptionalDouble.of(-0.5)))
        .isCloseTo(-MAX_MPS - 1.0, within(1.0e-9));
  }

  @Test
  void step_speedUnknown_staysAsItIs() {
    double before = after(1.0, DRIVES, OptionalDouble.of(0.2));

    assertThat(after(10.0, DRIVES, OptionalDouble.empty())).isEqualTo(before);
  }

  @Test
  void step_standing_isNone() {
    after(10.0, DRIVES, OptionalDouble.of(0.5));

    assertThat(after(0.1, Drive.STANDING, OptionalDouble.of(0.1))).isZero();
  }

  @Test
  void step_fromDrivingToATurnOnTheSpot_beginsAnew() {
    after(10.0, DRIVES, OptionalDouble.of(0.5));

    assertThat(after(0.1, TURNS, OptionalDouble.of(0.1))).isCloseTo(0.002, within(1.0e-9));
    assertThat(after(1.0, TURNS, OptionalDouble.of(0.1))).isPositive();
  }
}
