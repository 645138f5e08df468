package org.u2sa.planning.station;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class StationWaitTest {
  private final StationWait wait = new StationWait();

  @Test
  void remark_waitsOffAndOn_isReportedOnceAndAgainAfterTenSecondsOfMoving() {
    assertThat(wait.remark(false, 0L)).isEmpty();
    assertThat(wait.remark(true, 100_000L)).startsWith("waits: ");
    assertThat(wait.remark(false, 200_000L)).isEmpty();
    assertThat(wait.remark(true, 300_000L)).isEmpty();
    assertThat(wait.remark(true, 20_000_000L)).startsWith("waits: ");

    wait.begin();
    assertThat(wait.remark(true, 20_100_000L)).as("the next station").startsWith("waits: ");
  }
}
