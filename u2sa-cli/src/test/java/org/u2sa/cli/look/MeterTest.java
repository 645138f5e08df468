package org.u2sa.cli.look;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.JsonText;
import org.u2sa.messages.StateInformation;

class MeterTest {
  private static final long SECOND = 1_000_000;

  private static Meter.Rate meter(long intervalMicros, int messages) {
    Meter.Rate meter = new Meter.Rate();
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
    Meter.Rate meter = meter(intervalMicros, 21);
    assertThat(meter.cells(20 * intervalMicros + silentMicros).get(1)).isEqualTo(rate);
  }

  @Test
  void cells_oneMessage_hasNoRate() {
    assertThat(meter(SECOND, 1).cells(5 * SECOND))
        .hasSameSizeAs(Meter.Rate.COLUMNS)
        .containsExactly("1", "", "", "", "", "");
  }

  @Test
  void rate_threeMessagesInASecond_isTwoHertz() {
    Meter.Rate meter = new Meter.Rate();
    for (long micros : new long[] {1_000_000, 1_400_000, 2_000_000}) {
      meter.take(micros, new StateInformation());
    }
    assertThat(meter.cells(2_000_000))
        .containsExactly("3", "2.00 Hz", "400.0 ms", "500.0 ms", "600.0 ms", "100.0 ms");
  }

  @Test
  void delay_otherClock_isSaid() {
    Meter.Delay meter = new Meter.Delay();
    StateInformation state = new StateInformation();
    state.timestamp(1_000L);
    meter.take(1_800_000_000_000_000L, state);
    assertThat(meter.cells(0)).last().asString().contains("another clock");
    Meter.Delay same = new Meter.Delay();
    same.take(3_500L, state);
    assertThat(same.cells(0)).containsExactly("1", "2.50 ms", "2.50 ms", "2.50 ms", "2.50 ms", "");
  }

  @ParameterizedTest
  @CsvSource({"999, ''", "1001, 'from the future: the clocks differ'"})
  void delay_ahead_isRemarkedBeyondWhatClocksOfOneMachineDiffer(long aheadMicros, String remark) {
    Meter.Delay meter = new Meter.Delay();
    StateInformation state = new StateInformation();
    state.timestamp(5_000_000L + aheadMicros);
    meter.take(5_000_000L, state);
    assertThat(meter.cells(0)).last().isEqualTo(remark);
  }

  @Test
  void bandwidth_bytesPerSecond_areOfTheWholeTime() {
    Meter.Bandwidth meter = new Meter.Bandwidth(0);
    StateInformation state = new StateInformation().sensorName("a");
    meter.take(1, state);
    meter.take(2, state);
    JsonText json = new JsonText();
    meter.addTo(json, 2_000_000);
    int bytes = state.serialize().length;
    assertThat(json.line()).contains("\"bytesPerS\":" + (double) bytes + ",");
  }
}
