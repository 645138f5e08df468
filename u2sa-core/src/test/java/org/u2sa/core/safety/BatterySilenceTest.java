package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.safety.FailsafeAction;

/** A battery whose sensor falls silent. */
@Timeout(120)
class BatterySilenceTest extends WatchedVehicle {
  @BeforeEach
  void expectBatteries() {
    kit.with("BATTERY DEADLINE", 10.0);
  }

  @Test
  void battery_silentBeyondTheDeadline_isACauseUntilHeardAgain() {
    kit.with("RESUME", true);
    startArmed();
    battery(12.5, 80.0);
    live(9.9);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);

    live(0.4);

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.RETURN);
    assertThat(failsafe().causes().get(0)).startsWith("battery sensor: main silent for 10.");
    battery(12.5, 80.0);
    live(4.0);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @Test
  void battery_silentBeforeArming_isAReasonNotToArm() {
    start();
    live(10.5);

    assertThat(arm(true).reasons()).singleElement().asString().startsWith("battery sensor: main");
  }

  @Test
  void battery_exchangedOnTheGround_isForgottenAfterAMinute() {
    start();
    live(59.0);
    assertThat(arm(true).reasons()).anyMatch(reason -> reason.startsWith("battery sensor: main"));
    live(3.0);

    assertThat(arm(true).reasons()).noneMatch(reason -> reason.startsWith("battery sensor"));
  }

  @Test
  void battery_namedAndSilentOnTheGround_staysAReasonNotToArm() {
    kit.with("BATTERIES", "main");
    start();
    live(90.0);

    assertThat(arm(true).reasons()).anyMatch(reason -> reason.startsWith("battery sensor: main"));
  }

  @Test
  void battery_silentThatDoesNotCount_isNoCause() {
    kit.with("BATTERIES", "spare");
    start();
    live(10.5);

    assertThat(arm(true).reasons()).noneMatch(reason -> reason.startsWith("battery sensor"));
  }

  @Test
  void battery_namedButNeverHeard_isACauseAfterTheDeadlineOfALaterThreshold() {
    kit.with("LOW BATTERY VOLTAGE", 0.0).with("CRITICAL BATTERY REMAINING", 0.0);
    kit.with("BATTERIES", "Nobody");
    SafetyManager manager = startArmedManager();

    assertThat(manager.setVariable("LOW BATTERY VOLTAGE", 11.0)).isTrue();
    for (int s = 0; s < 11; s++) {
      battery(12.5, 80.0);
      live(1.0);
    }

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.RETURN);
    assertThat(failsafe().causes().get(0)).startsWith("battery sensor: Nobody silent for 10.");
  }

  @Test
  void battery_silentWithoutAThreshold_isNoCause() {
    kit.with("LOW BATTERY VOLTAGE", 0.0).with("CRITICAL BATTERY REMAINING", 0.0);
    startArmed();
    live(20.0);

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @Test
  void restart_besideABatteryThatFellSilent_noticesThat() {
    SafetyManager before = startArmedManager();
    before.kill();

    kit.restart(before, SafetyManager::new);
    live(11.0);

    assertThat(failsafe().causes().get(0)).startsWith("battery sensor: main silent for 10.");
    assertThat(kit.latest(Channels.ARMING_STATE).orElseThrow().armed()).isTrue();
  }
}
