package org.u2sa.core.control.ground;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;

class TrimTest {
  private final Trim trim = new Trim("SPEED TRIM");

  private double after(double seconds, double demandedMps, OptionalDouble measuredMps) {
    double answer = 0.0;
    for (int i = 0; i < seconds * 10.0; i++) {
      answer = trim.step(demandedMps > 0.0, demandedMps, measuredMps, 0.2, 0.3, 0.1);
    }
    return answer;
  }

  @Test
  void step_slowerThanCommanded_commandsMoreUpToTheLimit() {
    assertThat(after(1.0, 1.0, OptionalDouble.of(0.8))).isBetween(0.03, 0.05);
    assertThat(after(100.0, 1.0, OptionalDouble.of(0.8))).isEqualTo(0.3);
  }

  @Test
  void step_speedUnknown_staysAsItIs() {
    double before = after(1.0, 1.0, OptionalDouble.of(0.8));

    assertThat(after(10.0, 1.0, OptionalDouble.empty())).isEqualTo(before);
  }

  @Test
  void step_standing_isNone() {
    after(10.0, 1.0, OptionalDouble.of(0.5));

    assertThat(after(0.1, 0.0, OptionalDouble.of(-0.1))).isZero();
  }
}
