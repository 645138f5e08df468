package org.u2sa.core.health;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;

/** The monitor demands a failsafe in place of a Safety Manager that is gone. */
@Timeout(120)
class SafetyManagerLossTest extends WatchedWorker {
  private void armed(boolean armed) {
    kit.publish(Channels.ARMING_STATE, new ArmingState().armed(armed));
  }

  /** A Safety Manager that speaks every second. */
  private void armedFor(double forS) {
    for (double s = 0.0; s < forS; s++) {
      armed(true);
      kit.advance(1.0);
    }
  }

  private List<FailsafeAction> demanded() {
    return kit.published(Channels.FAILSAFE).stream().map(FailsafeState::action).toList();
  }

  @Test
  void silentWhileArmed_demandsHoldEverySecondUntilHeardAgain() {
    monitor();
    armedFor(30.0);
    kit.advance(3.9);
    assertThat(demanded()).isEmpty();

    kit.advance(5.0);
    assertThat(demanded()).hasSizeBetween(4, 5).containsOnly(FailsafeAction.HOLD);
    assertThat(kit.latest(Channels.FAILSAFE).orElseThrow().causes().get(0))
        .startsWith("safety manager: silent for ");

    kit.forget();
    armedFor(5.0);
    assertThat(demanded()).isEmpty();
  }

  @Test
  void silentWhileAMoreSevereActionIsInForce_demandsThat() {
    monitor();
    armed(true);
    kit.publish(Channels.FAILSAFE, new FailsafeState().action(FailsafeAction.LAND));
    kit.forget();
    kit.advance(15.0);

    assertThat(demanded()).isNotEmpty().containsOnly(FailsafeAction.LAND);
  }

  @Test
  void silentWithAnotherActionAndDeadline_followsThem() {
    kit.with("ON SAFETY MANAGER LOSS", "RETURN").with("SAFETY MANAGER DEADLINE", 20.0);
    monitor();
    armed(true);
    kit.advance(20.0);
    assertThat(demanded()).isEmpty();
    kit.advance(0.5);

    assertThat(demanded()).containsExactly(FailsafeAction.RETURN);
  }

  @Test
  void silentWithContinue_demandsNothing() {
    kit.with("ON SAFETY MANAGER LOSS", "CONTINUE");
    monitor();
    armed(true);
    kit.advance(30.0);

    assertThat(demanded()).isEmpty();
  }

  @Test
  void silentAfterDisarming_demandsNothing() {
    monitor();
    armed(true);
    armed(false);
    kit.advance(30.0);

    assertThat(demanded()).isEmpty();
  }

  @Test
  void armedStateOfAnEarlierRun_demandsNothing() {
    armed(true); // kept by the broker
    kit.advance(20.1);
    monitor();
    kit.advance(30.0);

    assertThat(demanded()).isEmpty();
  }

  @Test
  void restart_afterTheSafetyManagerWasLost_demandsItsFailsafe() {
    HealthMonitor before = monitor();
    armed(true);
    kit.advance(30.0);
    kit.forget();
    kit.restart(before, HealthMonitor::new);
    kit.advance(12.0);

    assertThat(demanded()).isNotEmpty().containsOnly(FailsafeAction.HOLD);
  }
}
