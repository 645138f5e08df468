package org.u2sa.estimation.measurement;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PositionGridTest {
  private final Random random = new Random(5);
  private final double[] numbers = new double[PositionGrid.SIZE];

  private double record(double first, double second) {
    PositionGrid.record(numbers, 0, first, second);
    return Math.max(PositionGrid.step(numbers, 0, 0), PositionGrid.step(numbers, 0, 1));
  }

  @Test
  void step_roundedCoordinates_isFound() {
    double first = 0.0;
    double second = 0.0;
    for (int i = 0; i < 100; i++) {
      record(0.5 * Math.rint(100.0 + 0.13 * i), 0.25 * Math.rint(50.0 - 0.07 * i));
      first = Math.max(first, PositionGrid.step(numbers, 0, 0));
      second = Math.max(second, PositionGrid.step(numbers, 0, 1));
    }
    assertThat(first).isCloseTo(0.5, within(1e-9));
    assertThat(second).isCloseTo(0.25, within(1e-9));
  }

  @Test
  void step_oneRoundedCoordinate_otherHasNone() {
    for (int i = 0; i < 100; i++) {
      record(0.5 * Math.rint(100.0 + 0.13 * i), 50.0 + 0.02 * random.nextGaussian());
    }
    assertThat(PositionGrid.step(numbers, 0, 0)).isCloseTo(0.5, within(1e-9));
    assertThat(PositionGrid.step(numbers, 0, 1)).isZero();
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 10})
  void step_fixesPublishedSeveralTimes_isNoRounding(int times) {
    double found = 0.0;
    for (int i = 0; i < 1000; i++) {
      double noise = i < 500 ? 0.0 : 0.01;
      double first = 100.0 + 0.19 * i + noise * random.nextGaussian();
      double second = 50.0 - 0.19 * i + noise * random.nextGaussian();
      for (int k = 0; k < times; k++) {
        found = Math.max(found, record(first, second));
      }
    }
    assertThat(found).isZero();
  }

  @Test
  void step_coordinatesWithNoisePublishedOneAfterTheOther_haveNone() {
    double found = 0.0;
    double second = 50.0;
    for (int i = 0; i < 10_000; i++) {
      double first = 100.0 + 0.5 * i + 0.01 * random.nextGaussian();
      found = Math.max(found, record(first, second));
      second = 50.0 + 0.5 * i + 0.01 * random.nextGaussian();
      found = Math.max(found, record(first, second));
    }
    assertThat(found).isZero();
  }

  @Test
  void step_legsAlongTheAxesPublishedTwice_isNoRounding() {
    double found = 0.0;
    double first = 100.0;
    double second = 50.0;
    for (int i = 0; i < 1000; i++) {
      first += i / 10 % 2 == 0 ? 0.19 : 0.0;
      second += i / 10 % 2 == 0 ? 0.0 : 0.19;
      record(first, second);
      found = Math.max(found, record(first, second));
    }
    assertThat(found).isZero();
  }
}
