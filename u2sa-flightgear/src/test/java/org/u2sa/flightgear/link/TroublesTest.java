package org.u2sa.flightgear.link;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.time.LockstepClock;

final class TroublesTest {
  private final LockstepClock clock = new LockstepClock();
  private final Troubles troubles = new Troubles(clock);

  @Test
  void take_events_eachOnceInTheirOrder() {
    troubles.event("lost");
    troubles.event("restored");
    assertThat(troubles.take()).isEqualTo("lost; restored");
    assertThat(troubles.take()).isEmpty();
  }

  @Test
  void take_refusedLines_firstAtOnceThenOnePauseApartWithTheirNumber() throws InterruptedException {
    troubles.refusedLine("a");
    assertThat(troubles.take()).isEqualTo("1 line from FlightGear refused: a");
    for (int i = 0; i < 500; i++) {
      troubles.refusedLine("b");
    }
    assertThat(troubles.take()).isEmpty();
    clock.advance(Troubles.PAUSE_MICROS);
    assertThat(troubles.take()).isEqualTo("500 lines from FlightGear refused, the last: b");
    assertThat(troubles.refusedLines()).isEqualTo(501);
  }

  @Test
  void event_nobodyAsks_keepsTheNewestOnly() {
    for (int i = 0; i < 1_000; i++) {
      troubles.event("event " + i);
    }
    assertThat(troubles.take()).startsWith("event 980; ").endsWith("; event 999");
  }
}
