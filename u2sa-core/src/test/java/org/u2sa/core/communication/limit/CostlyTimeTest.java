package org.u2sa.core.communication.limit;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class CostlyTimeTest {
  private static final long MILLI = 1_000; // µs

  private final CostlyTime time = new CostlyTime(0);

  @Test
  void isOpen_onlyClient_onlyPausesBetweenPieces() {
    assertThat(time.isOpen("a", 0)).isTrue();
    time.take("a", 1.0, 0);
    assertThat(time.isOpen("a", 99 * MILLI)).isFalse();
    assertThat(time.isOpen("a", 100 * MILLI)).isTrue();
    time.take("a", 0.004, 104 * MILLI);
    assertThat(time.isOpen("a", 104 * MILLI)).isTrue();
    time.take("a", 1.0, 1_104 * MILLI);
    assertThat(time.isOpen("a", 1_104 * MILLI)).isFalse();
    assertThat(time.isOpen("a", 1_105 * MILLI)).isTrue();
  }

  @Test
  void isOpen_anotherClientAsks_bothShareHalfOfTheTime() {
    time.isOpen("a", 0);
    assertThat(time.isOpen("a", 200 * MILLI)).isTrue();
    assertThat(time.isOpen("b", 201 * MILLI)).as("what one used alone is not owed").isTrue();
    time.take("b", 0.025, 201 * MILLI); // 5 ms could be taken at once
    assertThat(time.isOpen("a", 210 * MILLI)).isFalse();
    assertThat(time.isOpen("b", 220 * MILLI)).isFalse();
    assertThat(time.isOpen("a", 242 * MILLI)).isTrue();
  }
}
