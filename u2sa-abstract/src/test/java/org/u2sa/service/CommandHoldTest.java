package org.u2sa.service;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Set;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.LockstepClock;
import org.u2sa.messages.PercentageCommand;

class CommandHoldTest {
  private final LockstepClock clock = new LockstepClock();
  private final CommandHold hold = new CommandHold(clock, 0.5, Set.of("RUDDER"));

  private static PercentageCommand rudder(long timestampMicros) {
    PercentageCommand command = PercentageCommand.of("RUDDER", 40.0);
    command.timestamp(timestampMicros);
    return command;
  }

  @Test
  void accept_timestampAheadOfTheClock_holdsNoLongerThanItsExpiry() throws InterruptedException {
    hold.accept(rudder(3_600_000_000L));
    clock.advance(499_999);
    assertThat(hold.percentage("RUDDER")).hasValue(40.0);

    clock.advance(1);

    assertThat(hold.percentage("RUDDER")).isEmpty();
  }

  @Test
  void accept_expiryBeyondAllTime_holds() throws InterruptedException {
    PercentageCommand command = rudder(0);
    command.expiry(1e300);

    assertThat(hold.accept(command)).isTrue();
    clock.advance(1_000_000_000L);
    assertThat(hold.percentage("RUDDER")).hasValue(40.0);
  }

  @Test
  void accept_tooOldOnArrival_isRefusedAndCounted() throws InterruptedException {
    clock.advance(600_000);

    assertThat(hold.accept(rudder(100_000))).isFalse();
    assertThat(hold.refused()).isEqualTo(1);
    assertThat(hold.percentage("RUDDER")).isEmpty();
  }
}
