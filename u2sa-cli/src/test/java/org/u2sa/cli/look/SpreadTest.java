package org.u2sa.cli.look;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;

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
  void axis_oneValue_isInTheMiddle() {
    assertThat(TextPlot.Axis.around(5.0, 5.0).share(5.0)).isCloseTo(0.5, within(1e-9));
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
