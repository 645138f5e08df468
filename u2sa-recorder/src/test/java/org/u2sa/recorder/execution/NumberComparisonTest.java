package org.u2sa.recorder.execution;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class NumberComparisonTest {
  @ParameterizedTest
  @CsvSource({
    "rad, 0.1, 6.2, -0.183185307",
    "rad, 6.2, 0.1, 0.183185307",
    "deg, 179.9, -179.8, 0.3",
    "m, 179.9, -179.8, -359.7",
    "rad/s, 0.1, 6.2, 6.1"
  })
  void deviation_numberWithUnit_goesTheShorterWayRoundOnlyForAngles(
      String unit, double recorded, double now, double expected) {
    NumberComparison number = new NumberComparison("x", unit);
    number.add(0.0, recorded, now);
    assertThat(number.deviation(recorded, now)).isCloseTo(expected, within(1e-9));
    assertThat(number.rms()).isCloseTo(Math.abs(expected), within(1e-9));
    assertThat(number.largest()).isCloseTo(Math.abs(expected), within(1e-9));
  }
}
