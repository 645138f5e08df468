package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.FailsafeAction;
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

    startManager();
    live(3.0);

    assertThat(kit.published(Channels.FAILSAFE))
        .isNotEmpty()
        .allMatch(state -> state.action() == FailsafeAction.RETURN);
    assertThat(failsafe().causes().get(0))
        .startsWith("operator link: \"Ann\" silent for ")
        .endsWith("s (over; stays until armed again)");
    assertThat(kit.published(Channels.ARMING_STATE)).isNotEmpty().allMatch(ArmingState::armed);
    arm(true);
    live(0.2);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @Test
  void start_longAfterAnother_isAnotherRun() {
    startArmedManager().kill();
    kit.advance(25.0);

    startManager();

    assertThat(kit.latest(Channels.ARMING_STATE).orElseThrow().armed()).isFalse();
  }

  @Test
  void start_anewAfterADisarm_staysDisarmed() {
    SafetyManager before = startArmedManager();
    arm(false);
    before.kill();

    startManager();
    live(3.0);

    assertThat(kit.latest(Channels.ARMING_STATE).orElseThrow().armed()).isFalse();
  }
}
