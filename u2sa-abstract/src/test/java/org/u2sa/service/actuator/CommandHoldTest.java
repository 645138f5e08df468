package org.u2sa.service.actuator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.command.ActuatorCommand;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;

class CommandHoldTest {
  private final LockstepClock clock = new LockstepClock();
  private final CommandHold hold = hold(0.5);

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

  private static PercentageCommand percent(double percentage) {
    return PercentageCommand.of("RUDDER", percentage);
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

  private CommandHold hold(double defaultExpiryS) {
    return new CommandHold(
        clock, "boat", defaultExpiryS, 1.0, Map.of("RUDDER", Range.of(-50.0, 50.0)));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.0, -0.1, Double.NaN})
  void new_expiryThatIsNotPositive_isRefused(double expiryS) {
    assertThatThrownBy(() -> hold(expiryS))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("defaultExpiryS: " + expiryS + " is not positive");
  }

  @Test
  void accept_atEitherEndOfTheRange_holds() {
    assertThat(hold.accept(percent(-50.0))).isEmpty();
    assertThat(hold.percentage("RUDDER")).hasValue(-50.0);
    assertThat(hold.accept(percent(50.0))).isEmpty();
    assertThat(hold.percentage("RUDDER")).hasValue(50.0);
  }

  @Test
  void accept_namedForThisSystem_holds() {
    PercentageCommand command = percent(10.0);
    command.systemId("boat");

    assertThat(hold.accept(command)).isEmpty();
  }

  @Test
  void accept_inTheMomentItExpires_isTooOldAndAMicrosecondBeforeIsNot()
      throws InterruptedException {
    clock.advance(600_000);

    assertThat(hold.accept(rudder(100_000))).contains(CommandRefusal.TOO_OLD);
    assertThat(hold.accept(rudder(100_001))).isEmpty();
  }

  @Test
  void accept_withoutATime_isOfNow() throws InterruptedException {
    clock.advance(3_000_000);
    hold.accept(percent(10.0));

    clock.advance(499_999);
    assertThat(hold.percentage("RUDDER")).hasValue(10.0);
    clock.advance(1);
    assertThat(hold.percentage("RUDDER")).isEmpty();
  }

  @Test
  void limit_heldCommandAtTheNewEnd_staysAndOneBeyondIsDropped() {
    hold.accept(percent(30.0));
    hold.limit(new ActuatorAnnouncement().actuatorName("RUDDER").minimum(0.0).maximum(30.0));
    assertThat(hold.percentage("RUDDER")).hasValue(30.0);

    hold.limit(new ActuatorAnnouncement().actuatorName("RUDDER").minimum(0.0).maximum(29.9));

    assertThat(hold.percentage("RUDDER")).isEmpty();
    assertThat(hold.accept(percent(29.95))).contains(CommandRefusal.OUT_OF_RANGE);
    assertThat(hold.accept(percent(-0.1))).contains(CommandRefusal.OUT_OF_RANGE);
    assertThat(hold.accept(percent(29.9))).isEmpty();
  }

  @Test
  void limit_ofAnActuatorThatIsNotHere_addsNone() {
    hold.limit(new ActuatorAnnouncement().actuatorName("SAIL").minimum(0.0).maximum(10.0));

    assertThat(hold.accept(PercentageCommand.of("SAIL", 5.0)))
        .contains(CommandRefusal.NOT_ADDRESSED);
  }

  @Test
  void standing_commandThatHolds_isItsPercentageWithTheTimeThatIsLeft()
      throws InterruptedException {
    hold.accept(percent(10.0));
    clock.advance(200_000);

    assertThat(hold.standing())
        .singleElement()
        .satisfies(
            command -> {
              assertThat(command.actuatorName()).isEqualTo("RUDDER");
              assertThat(((PercentageCommand) command).percentage()).isEqualTo(10.0);
              assertThat(command.expiry()).hasValue(0.3);
              assertThat(command.timestamp()).hasValue(200_000);
            });
  }

  @Test
  void standing_commandInTheMomentItExpires_isNone() throws InterruptedException {
    hold.accept(percent(10.0));
    clock.advance(499_999);
    assertThat(hold.standing()).hasSize(1);

    clock.advance(1);

    assertThat(hold.standing()).isEmpty();
  }

  @Test
  void forget_everything_isNeutral() {
    hold.accept(percent(10.0));

    hold.forget();

    assertThat(hold.percentage("RUDDER")).isEmpty();
    assertThat(hold.standing()).isEmpty();
  }
}
