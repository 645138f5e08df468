package org.u2sa.estimation.measurement;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;

class PositionGridTest {
  private final Random random = new Random(5);
  private final double[] numbers = new double[PositionGrid.SIZE];

  @Test
  void step_roundedCoordinate_isFound() {
    double found = 0.0;
    for (int i = 0; i < 100; i++) {
      found = PositionGrid.step(numbers, 0, 0.5 * Math.rint(100.0 + 0.13 * i));
    }
    assertThat(found).isCloseTo(0.5, within(1e-9));
  }

  @Test
  void step_coordinateWithNoise_hasNone() {
    int found = 0;
    for (int i = 0; i < 10_000; i++) {
      double value = 100.0 + 0.1 * i + 0.02 * random.nextGaussian();
      found += PositionGrid.step(numbers, 0, value) > 0.0 ? 1 : 0;
    }
    assertThat(found).isZero();
  }

  @Test
  void step_constantSpeed_isNoRounding() {
    double found = 0.0;
    for (int i = 0; i < 100; i++) {
      found = Math.max(found, PositionGrid.step(numbers, 0, 100.0 + 0.19 * i));
    }
    assertThat(found).isZero();
  }
}
