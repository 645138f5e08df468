package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.safety.OperatorHeartbeat;

/** What a SafetyManager takes over from the one before it. */
@Timeout(120)
class SafetyManagerRestartTest extends WatchedVehicle {
  @Test
  void start_anewInAFailsafe_staysArmedAndGoesOnWithIt() {
    SafetyManager before = startArmedManager();
    kit.publish(Channels.OPERATOR, new OperatorHeartbeat().operator("Ann"));
    live(5.3);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.RETURN);
    before.kill();
    kit.forget();
    live(5.0);

    restart(before);
    live(3.0);

    assertThat(kit.published(Channels.FAILSAFE))
        .isNotEmpty()
        .allMatch(state -> state.action() == FailsafeAction.RETURN);
    assertThat(failsafe().causes().get(0))
        .startsWith("operator link: \"Ann\" silent for ")
        .endsWith(" s");
    assertThat(kit.published(Channels.ARMING_STATE)).isNotEmpty().allMatch(ArmingState::armed);
    kit.publish(Channels.OPERATOR, new OperatorHeartbeat().operator("Ann"));
    arm(true);
    live(0.2);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @Test
  void restart_atTheThirdAttempt_staysArmed() {
    SafetyManager before = startArmedManager();
    before.kill();
    kit.advance(75.0);

    restart(before);

    assertThat(kit.latest(Channels.ARMING_STATE).orElseThrow().armed()).isTrue();
  }

  @Test
  void restart_longAfterItEnded_isDisarmed() {
    SafetyManager before = startArmedManager();
    before.kill();
    kit.advance(121.0);

    restart(before);

    assertThat(kit.latest(Channels.ARMING_STATE).orElseThrow().armed()).isFalse();
  }

  @Test
  void start_anewAfterADisarm_staysDisarmed() {
    SafetyManager before = startArmedManager();
    arm(false);
    before.kill();

    restart(before);
    live(3.0);

    assertThat(kit.latest(Channels.ARMING_STATE).orElseThrow().armed()).isFalse();
  }

  @Test
  void start_besideTheArmedStateOfAnother_isDisarmed() {
    startArmedManager().kill();

    startManager();
    live(3.0);

    assertThat(kit.latest(Channels.ARMING_STATE).orElseThrow().armed()).isFalse();
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @Test
  void restart_neverArmedBesideTheArmedStateAndFailsafeOfAnother_isDisarmedAndInNone() {
    SafetyManager before = start();
    before.kill();
    kit.publish(Channels.ARMING_STATE, new ArmingState().armed(true));
    kit.publish(
        Channels.FAILSAFE,
        new FailsafeState().action(FailsafeAction.RETURN).causes(List.of("operator link: forged")));

    restart(before);
    live(3.0);

    assertThat(kit.latest(Channels.ARMING_STATE).orElseThrow().armed()).isFalse();
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @Test
  void restart_twiceAtOnce_staysArmed() {
    SafetyManager before = startArmedManager();
    before.kill();
    SafetyManager second = kit.restart(before, SafetyManager::new);
    second.kill(); // before it has begun

    restart(second);
    live(3.0);

    assertThat(kit.latest(Channels.ARMING_STATE).orElseThrow().armed()).isTrue();
  }

  @Test
  void restart_afterTheLinkToTheOperatorWasLost_noticesThat() {
    SafetyManager before = startArmedManager();
    kit.publish(Channels.OPERATOR, new OperatorHeartbeat().operator("Ann"));
    live(1.0);
    before.kill(); // and with it goes the operator

    restart(before);
    live(4.0);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
    live(2.0);

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.RETURN);
    assertThat(failsafe().causes().get(0)).startsWith("operator link: \"Ann\" silent for ");
  }

  private SafetyManager restart(SafetyManager before) {
    SafetyManager after = kit.restart(before, SafetyManager::new);
    kit.advance(0.6);
    return after;
  }

  @Test
  void restart_stopGivenAndClearedInItsAbsence_isDisarmed() {
    SafetyManager before = startArmedManager();
    kit.publish(Channels.EMERGENCY_STOP, stop("Ann 1"));
    kit.publish(Channels.EMERGENCY_STOP, clear("Ann 1"));
    arm(true);
    SafetyManager second = restart(before); // the same clear, which it had heard
    assertThat(kit.latest(Channels.ARMING_STATE).orElseThrow().armed()).isTrue();

    second.kill();
    kit.publish(Channels.EMERGENCY_STOP, stop("Ann 2"));
    kit.advance(1.0);
    kit.publish(Channels.EMERGENCY_STOP, clear("Ann 2"));
    restart(second);

    assertThat(kit.latest(Channels.ARMING_STATE).orElseThrow().armed()).isFalse();
    assertThat(kit.log("SafetyManager"))
        .anyMatch(line -> line.contains("an emergency stop was cleared while no Safety Manager"));
  }

  private static EmergencyStop stop(String id) {
    return new EmergencyStop().active(true).stopId(id).operator("Ann");
  }

  private static EmergencyStop clear(String id) {
    return new EmergencyStop().active(false).lifts(List.of(id)).operator("Ann");
  }

  @Test
  void restart_savedStateIsLostInAFailsafe_staysArmedAndInIt() {
    SafetyManager before = startArmedManager();
    kit.publish(Channels.EMERGENCY_STOP, stop("Ann 1"));
    kit.publish(Channels.EMERGENCY_STOP, clear("Ann 1"));
    live(0.2);
    arm(true);
    kit.publish(Channels.OPERATOR, new OperatorHeartbeat().operator("Ann"));
    live(5.3);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.RETURN);
    before.kill();
    kit.loseState("SafetyManager");
    kit.forget();

    restart(before);
    live(4.0);

    assertThat(kit.published(Channels.ARMING_STATE)).isNotEmpty().allMatch(ArmingState::armed);
    assertThat(kit.published(Channels.FAILSAFE))
        .isNotEmpty()
        .allMatch(state -> state.action() == FailsafeAction.RETURN);
    assertThat(failsafe().causes().get(0)).startsWith("operator link: \"Ann\" silent for ");
  }

  @Test
  void restart_savedStateIsLostAndStoppedInItsAbsence_isDisarmed() {
    SafetyManager before = startArmedManager();
    before.kill();
    kit.loseState("SafetyManager");
    kit.advance(1.0);
    kit.publish(Channels.EMERGENCY_STOP, stop("Ann 1"));
    kit.publish(Channels.EMERGENCY_STOP, clear("Ann 1"));

    restart(before);

    assertThat(kit.latest(Channels.ARMING_STATE).orElseThrow().armed()).isFalse();
  }

  @Test
  void restart_repeatedlyBeforeTheDeadline_losesTheOperatorAfterOneMoreDeadline() {
    SafetyManager manager = startArmedManager();
    kit.publish(Channels.OPERATOR, new OperatorHeartbeat().operator("Ann"));
    live(3.0);
    for (int i = 0; i < 3; i++) { // deadline: 5 s
      assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
      manager = kit.restart(manager, SafetyManager::new);
      live(2.0);
    }

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.RETURN);
  }

  @Test
  void arm_orderOfBeforeTheRestartArrivesAgain_doesNotArm() {
    SafetyManager manager = start();
    live(0.3);
    ArmCommand command = armCommand(true);
    assertThat(arm(command).armed()).isTrue();
    assertThat(arm(false).armed()).isFalse();
    kit.restart(manager, SafetyManager::new);
    live(1.0);

    assertThat(arm(command).reasons())
        .containsExactly("this order was answered before: give it under another ID");
    ArmCommand slowClock = armCommand(true);
    slowClock.timestamp(kit.clock().micros() - 4_000_000L); // seems to be of before the restart
    assertThat(arm(slowClock).reasons()).noneMatch(reason -> reason.contains("order"));
  }

  @Test
  void arm_orderOfBeforeARestartWithoutState_isRefused() {
    SafetyManager before = kit.start(SafetyManager::new); // has saved nothing yet
    ArmCommand command = armCommand(true);
    command.timestamp(kit.clock().micros());
    kit.restart(before, SafetyManager::new);
    live(1.0);

    assertThat(arm(command).reasons())
        .containsExactly(
            "the order was given before the Safety Manager was restarted: give it again");
    assertThat(arm(true).reasons()).noneMatch(reason -> reason.contains("was given"));
  }
}
