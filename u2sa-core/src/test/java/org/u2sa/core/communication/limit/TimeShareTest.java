package org.u2sa.core.communication.limit;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** How much of a thread's time work gets. */
class TimeShareTest {
  private long nowMicros;
  private final TimeShare share = new TimeShare(0.1, 0.005, () -> nowMicros);

  @Test
  void isOpen_moreWorkThanItsPart_isOpenForATenthOfTheTime() {
    long workedMicros = 0;
    while (nowMicros < 10_000_000) {
      if (share.isOpen()) {
        share.run(() -> nowMicros += 300);
        workedMicros += 300;
      } else {
        nowMicros += 100;
      }
    }
    assertThat(workedMicros).isBetween(950_000L, 1_050_000L);
  }

  @Test
  void isOpen_afterALongPause_aSliceAndNoMore() {
    nowMicros += 3_600_000_000L;
    long before = nowMicros;
    for (int i = 0; i < 1_000 && share.isOpen(); i++) {
      share.run(() -> nowMicros += 100);
    }
    assertThat(nowMicros - before).isBetween(5_000L, 6_000L);
  }
}
