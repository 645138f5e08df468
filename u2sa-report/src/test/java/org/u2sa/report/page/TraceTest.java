package org.u2sa.report.page;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class TraceTest {
  @Test
  void trace_manyPoints_keepsLeastAndGreatest() {
    Trace trace = new Trace("t");
    for (int i = 0; i < 100_000; i++) {
      trace.add(i, i == 54_321 ? 99.0 : i == 54_322 ? -99.0 : Math.sin(i));
    }
    int[] kept = trace.kept();
    assertThat(kept.length).isLessThanOrEqualTo(1_600);
    assertThat(kept).contains(54_321, 54_322).isSorted();
  }

  @Test
  void rounded_smallNumbers_keepSixDigits() {
    assertThat(Trace.rounded(1.234567891e-7)).isEqualTo(1.23457e-7);
    assertThat(Trace.rounded(12.3456789)).isEqualTo(12.34568);
    assertThat(Trace.rounded(0.0)).isZero();
    assertThat(Trace.rounded(Double.NaN)).isZero();
  }

  @Test
  void rounded_largeNumbers_stayAsTheyAre() {
    assertThat(Trace.rounded(1.764e15)).isEqualTo(1.764e15);
    assertThat(Trace.rounded(-1e300)).isEqualTo(-1e300);
  }
}
