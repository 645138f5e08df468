package org.u2sa.service;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.service.actuator.CommandHold;
import org.u2sa.service.actuator.CommandRefusal;

/** Commands at the very limits of what an actuator takes, and of their time. */
class CommandHoldLimitsTest {
  private final LockstepClock clock = new LockstepClock();
  private final CommandHold hold = hold(0.5);

  private CommandHold hold(double defaultExpiryS) {
    return new CommandHold(
        clock, "boat", defaultExpiryS, 1.0, Map.of("RUDDER", Range.of(-50.0, 50.0)));
  }

  private static PercentageCommand rudder(double percentage) {
    return PercentageCommand.of("RUDDER", percentage);
  }

  private Optional<CommandRefusal> acceptSaidAt(long micros) {
    PercentageCommand command = rudder(10.0);
    command.timestamp(micros);
    return hold.accept(command);
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
    assertThat(hold.accept(rudder(-50.0))).isEmpty();
    assertThat(hold.percentage("RUDDER")).hasValue(-50.0);
    assertThat(hold.accept(rudder(50.0))).isEmpty();
    assertThat(hold.percentage("RUDDER")).hasValue(50.0);
  }

  @Test
  void accept_namedForThisSystem_holds() {
    PercentageCommand command = rudder(10.0);
    command.systemId("boat");

    assertThat(hold.accept(command)).isEmpty();
  }

  @Test
  void accept_inTheMomentItExpires_isTooOldAndAMicrosecondBeforeIsNot()
      throws InterruptedException {
    clock.advance(600_000);

    assertThat(acceptSaidAt(100_000)).contains(CommandRefusal.TOO_OLD);
    assertThat(acceptSaidAt(100_001)).isEmpty();
  }

  @Test
  void accept_withoutATime_isOfNow() throws InterruptedException {
    clock.advance(3_000_000);
    hold.accept(rudder(10.0));

    clock.advance(499_999);
    assertThat(hold.percentage("RUDDER")).hasValue(10.0);
    clock.advance(1);
    assertThat(hold.percentage("RUDDER")).isEmpty();
  }

  @Test
  void limit_heldCommandAtTheNewEnd_staysAndOneBeyondIsDropped() {
    hold.accept(rudder(30.0));
    hold.limit(new ActuatorAnnouncement().actuatorName("RUDDER").minimum(0.0).maximum(30.0));
    assertThat(hold.percentage("RUDDER")).hasValue(30.0);

    hold.limit(new ActuatorAnnouncement().actuatorName("RUDDER").minimum(0.0).maximum(29.9));

    assertThat(hold.percentage("RUDDER")).isEmpty();
    assertThat(hold.accept(rudder(29.95))).contains(CommandRefusal.OUT_OF_RANGE);
    assertThat(hold.accept(rudder(-0.1))).contains(CommandRefusal.OUT_OF_RANGE);
    assertThat(hold.accept(rudder(29.9))).isEmpty();
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
    hold.accept(rudder(10.0));
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
    hold.accept(rudder(10.0));
    clock.advance(499_999);
    assertThat(hold.standing()).hasSize(1);

    clock.advance(1);

    assertThat(hold.standing()).isEmpty();
  }

  @Test
  void forget_everything_isNeutral() {
    hold.accept(rudder(10.0));

    hold.forget();

    assertThat(hold.percentage("RUDDER")).isEmpty();
    assertThat(hold.standing()).isEmpty();
  }
}
