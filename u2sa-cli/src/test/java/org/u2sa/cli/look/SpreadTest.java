package org.u2sa.cli.look;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.JsonText;
import org.u2sa.messages.StateInformation;

class SpreadTest {
  @Test
  void quantiles_areNearestRanks() {
    Spread spread = new Spread();
    for (int i = 100; i >= 1; i--) {
      spread.add(i);
    }
    assertThat(spread.quantile(0.0)).isEqualTo(1);
    assertThat(spread.quantile(0.5)).isEqualTo(50);
    assertThat(spread.quantile(0.99)).isEqualTo(99);
    assertThat(spread.quantile(1.0)).isEqualTo(100);
    assertThat(spread.mean()).isEqualTo(50.5);
    assertThat(spread.deviation()).isCloseTo(28.8661, within(1e-4));
  }

  @Test
  void quantile_shareBetweenTwoRanks_isTheHigher() {
    Spread spread = new Spread();
    spread.add(1);
    spread.add(2);
    spread.add(3);
    assertThat(spread.quantile(0.5)).isEqualTo(2);
    assertThat(spread.quantile(0.99)).isEqualTo(3);
  }

  @Test
  void quantile_moreThanAreKept_isOfTheNewest() {
    Spread spread = new Spread();
    for (int i = 0; i < 25_000; i++) {
      spread.add(i);
    }
    assertThat(spread.count()).isEqualTo(25_000);
    assertThat(spread.quantile(0.0)).isEqualTo(15_000);
  }

  @Test
  void rate_threeMessagesInASecond_isTwoHertz() {
    RateMeter meter = new RateMeter();
    for (long micros : new long[] {1_000_000, 1_400_000, 2_000_000}) {
      meter.take(micros, new StateInformation());
    }
    assertThat(meter.cells(2_000_000))
        .containsExactly("3", "2.00 Hz", "400.0 ms", "500.0 ms", "600.0 ms", "100.0 ms");
  }

  @Test
  void delay_otherClock_isSaid() {
    DelayMeter meter = new DelayMeter();
    StateInformation state = new StateInformation();
    state.timestamp(1_000L);
    meter.take(1_800_000_000_000_000L, state);
    assertThat(meter.cells(0)).last().asString().contains("another clock");
    DelayMeter same = new DelayMeter();
    same.take(3_500L, state);
    assertThat(same.cells(0)).containsExactly("1", "2.50 ms", "2.50 ms", "2.50 ms", "2.50 ms", "");
  }

  @Test
  void bandwidth_bytesPerSecond_areOfTheWholeTime() {
    BandwidthMeter meter = new BandwidthMeter(0);
    StateInformation state = new StateInformation().sensorName("a");
    meter.take(1, state);
    meter.take(2, state);
    JsonText json = new JsonText();
    meter.addTo(json, 2_000_000);
    int bytes = state.serialize().length;
    assertThat(json.line()).contains("\"bytesPerS\":" + (double) bytes + ",");
  }

  @Test
  void axis_oneValue_isInTheMiddle() {
    assertThat(Axis.around(5.0, 5.0).share(5.0)).isCloseTo(0.5, within(1e-9));
  }

  @Test
  void textPlot_risingLine_endsAboveWhereItBegan() {
    Series series = new Series("a", "m");
    series.add(0.0, 0.0, 100);
    series.add(10.0, 10.0, 100);
    List<String> lines = new TextPlot(20, 5, false).lines(List.of(series), 0.0, 10.0);
    assertThat(lines).hasSize(6);
    String top = lines.get(1).substring(lines.get(1).indexOf('┤') + 1);
    String bottom = lines.get(5).substring(lines.get(5).indexOf('┤') + 1);
    assertThat(top.charAt(19)).isNotEqualTo('\u2800');
    assertThat(top.charAt(0)).isEqualTo('\u2800');
    assertThat(bottom.charAt(0)).isNotEqualTo('\u2800');
    assertThat(bottom.charAt(19)).isEqualTo('\u2800');
  }
}
