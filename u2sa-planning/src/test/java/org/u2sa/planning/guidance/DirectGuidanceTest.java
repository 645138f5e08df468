package org.u2sa.planning.guidance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DirectGuidanceTest {
  private static final double FOOT_M = 0.3048;

  @ParameterizedTest
  @CsvSource({
    "0, 0",
    "9.9, 0",
    "-10, 0",
    "1000, 1",
    "-1000, -1",
    "5000, 1",
    "505, 0.5",
    "-505, -0.5"
  })
  void scaled_differenceOfHeight_isThesissShare(double downFt, double share) {
    assertThat(DirectGuidance.scaled(downFt * FOOT_M)).isCloseTo(share, within(1.0e-9));
  }
}
