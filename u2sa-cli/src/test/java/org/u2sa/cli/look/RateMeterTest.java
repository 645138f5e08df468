package org.u2sa.cli.look;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.messages.StateInformation;

class RateMeterTest {
  private static final long SECOND = 1_000_000;

  private static RateMeter meter(long intervalMicros, int messages) {
    RateMeter meter = new RateMeter();
    for (int i = 0; i < messages; i++) {
      meter.take(i * intervalMicros, new StateInformation());
    }
    return meter;
  }

  @ParameterizedTest
  @CsvSource({
    "100000, 0, 10.00 Hz",
    "100000, 2000000, 10.00 Hz",
    "100000, 2000001, 0.00 Hz",
    "100000, 60000000, 0.00 Hz",
    "10000000, 50000000, 0.10 Hz",
    "10000000, 50000001, 0.00 Hz"
  })
  void cells_sourceSilentForAWhile_hasNoRateAfterIt(
      long intervalMicros, long silentMicros, String rate) {
    RateMeter meter = meter(intervalMicros, 21);
    assertThat(meter.cells(20 * intervalMicros + silentMicros).get(1)).isEqualTo(rate);
  }

  @Test
  void cells_oneMessage_hasNoRate() {
    assertThat(meter(SECOND, 1).cells(5 * SECOND))
        .hasSameSizeAs(RateMeter.COLUMNS)
        .containsExactly("1", "", "", "", "", "");
  }
}
