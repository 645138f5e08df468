package org.u2sa.service.actuator;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.command.ActuatorCommand;
import org.u2sa.messages.command.PercentageCommand;

class CommandHoldTest {
  private final LockstepClock clock = new LockstepClock();
  private final CommandHold hold =
      new CommandHold(clock, "boat", 0.5, 1.0, Map.of("RUDDER", Range.of(-50.0, 50.0)));

  /** A subclass that says what no field of a message can hold. */
  private static final class Odd extends PercentageCommand {
    private final double percentage;

    Odd(double percentage) {
      this.percentage = percentage;
      actuatorName("RUDDER").percentage(0.0);
    }

    @Override
    public double percentage() {
      return percentage;
    }
  }

  private static PercentageCommand rudder(long timestampMicros) {
    PercentageCommand command = PercentageCommand.of("RUDDER", 40.0);
    command.timestamp(timestampMicros);
    return command;
  }

  @Test
  void accept_timestampAheadOfTheClock_holdsNoLongerThanItsExpiry() throws InterruptedException {
    assertThat(hold.accept(rudder(1_000_000L))).isEmpty();
    clock.advance(499_999);
    assertThat(hold.percentage("RUDDER")).hasValue(40.0);

    clock.advance(1);

    assertThat(hold.percentage("RUDDER")).isEmpty();
  }

  @Test
  void accept_timestampFartherAheadThanClocksDiffer_isRefused() {
    assertThat(hold.accept(rudder(1_000_001L))).contains(CommandRefusal.FROM_THE_FUTURE);
    assertThat(hold.percentage("RUDDER")).isEmpty();
  }

  @Test
  void accept_expiryBeyondAllTime_holds() throws InterruptedException {
    PercentageCommand command = rudder(0);
    command.expiry(1e15);

    assertThat(hold.accept(command)).isEmpty();
    clock.advance(1_000_000_000L);
    assertThat(hold.percentage("RUDDER")).hasValue(40.0);
  }

  @Test
  void accept_tooOldOnArrival_isRefused() throws InterruptedException {
    clock.advance(600_000);

    assertThat(hold.accept(rudder(100_000))).contains(CommandRefusal.TOO_OLD);
    assertThat(hold.percentage("RUDDER")).isEmpty();
  }

  @Test
  void accept_outsideTheActuatorsRangeOrNoNumber_isRefused() {
    assertThat(hold.accept(PercentageCommand.of("RUDDER", 50.1)))
        .contains(CommandRefusal.OUT_OF_RANGE);
    assertThat(hold.accept(new Odd(Double.NaN))).contains(CommandRefusal.OUT_OF_RANGE);
    assertThat(hold.accept(new Odd(Double.POSITIVE_INFINITY)))
        .contains(CommandRefusal.OUT_OF_RANGE);
  }

  @Test
  void accept_otherSystemOtherKindOtherActuator_isRefusedAsSuch() {
    PercentageCommand foreign = rudder(0);
    foreign.systemId("other");

    assertThat(hold.accept(foreign)).contains(CommandRefusal.WRONG_SYSTEM);
    assertThat(hold.accept(new ActuatorCommand().actuatorName("RUDDER")))
        .contains(CommandRefusal.NOT_A_PERCENTAGE);
    assertThat(hold.accept(PercentageCommand.of("SAIL", 1.0)))
        .contains(CommandRefusal.NOT_ADDRESSED);
    assertThat(hold.percentage("RUDDER")).isEmpty();
  }
}
