package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.examples.LeakCheck;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.safety.FailsafeAction;

/** An extension's check among the Safety Manager's own. */
@Timeout(120)
class SafetyCheckTest extends WatchedVehicle {
  private void bilge(double depthM) {
    kit.publish(LeakCheck.BILGE, new StateInformation().sensorName("bilge").z(depthM));
  }

  @Test
  void trouble_whileArmed_isACauseWithItsDefaultAction() {
    startArmed();
    bilge(0.009);
    live(0.2);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
    bilge(0.02);
    live(0.2);

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.RETURN);
    assertThat(failsafe().causes()).containsExactly("leak: 2 cm of water");
  }

  @Test
  void trouble_withAnotherActionAndLimitConfigured_followsThem() {
    kit.with("ON LEAK", "STOP").with("LEAK DEPTH", 0.1);
    startArmed();
    bilge(0.09);
    live(0.2);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
    bilge(0.1);
    live(0.2);

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.STOP);
  }

  @Test
  void arm_withTrouble_isRefusedWithItsWords() {
    start();
    bilge(0.05);
    live(0.3);

    assertThat(arm(true).reasons()).containsExactly("leak: 5 cm of water");
  }

  @Test
  void see_thatThrows_isACauseAndOtherCausesStillCount() {
    startArmed();
    kit.publish(LeakCheck.BILGE, new StateInformation().sensorName("bilge"));
    sigmaM = 51.0;
    live(0.2);

    assertThat(failsafe().causes())
        .anyMatch(cause -> cause.startsWith("leak: the check failed: "))
        .contains("position: uncertain by 51 m, limit 50 m");
  }

  @Test
  void see_thatWorksAgain_endsTheCauseOfTheFault() {
    kit.with("ON LEAK", "HOLD");
    startArmed();
    kit.publish(LeakCheck.BILGE, new StateInformation().sensorName("bilge"));
    live(0.2);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.HOLD);
    bilge(0.0);
    live(3.5);

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }
}
