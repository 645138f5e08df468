package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.BatteryState;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.FailsafeAction;

/** Texts in messages, as long as they may be, keep no failsafe from acting. */
@Timeout(120)
class HostileTextsTest extends WatchedVehicle {
  private static final String LONG = "\uffe6".repeat(21_840); // 65,520 bytes in UTF-8

  @Test
  void service_givenUpForAReasonOf64KiB_stopsTheVehicle() {
    kit.with("ON SERVICE LOSS", "STOP");
    SafetyManager manager = startArmedManager();
    kit.publish(
        Channels.CONDITIONS, given("PathPlanner", Condition.DEAD).reason(LONG).action("failsafe"));
    live(0.2);

    EmergencyStop stop = kit.latest(Channels.EMERGENCY_STOP).orElseThrow();
    assertThat(stop.active()).isTrue();
    assertThat(stop.reason()).startsWith("service given up: service PathPlanner is DEAD: ");
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.STOP);
    assertThat(manager.status()).isEqualTo(ServiceStatus.RUNNING);
  }

  @Test
  void battery_lowWithTheLongestNameThereIs_stopsTheVehicle() {
    SafetyManager manager = startArmedManager();
    kit.publish(Channels.POWER, new BatteryState().sensorName("\uffe6".repeat(255)).remaining(1.0));
    live(10.3);

    assertThat(kit.latest(Channels.EMERGENCY_STOP).orElseThrow().active()).isTrue();
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.STOP);
    assertThat(manager.status()).isEqualTo(ServiceStatus.RUNNING);
  }

  @Test
  void arm_manyServicesFailForLongReasons_isRefusedWithReasonsThatFit() {
    SafetyManager manager = start();
    live(0.3);
    for (int i = 0; i < 200; i++) {
      condition("Service" + i, Condition.FAILED);
      kit.publish(Channels.CONDITIONS, given("Service" + i, Condition.FAILED).reason(LONG));
    }

    List<String> reasons = new ArrayList<>(arm(true).reasons());

    assertThat(reasons).hasSize(100);
    assertThat(reasons.get(99)).isEqualTo("and 101 more");
    assertThat(manager.status()).isEqualTo(ServiceStatus.RUNNING);
  }
}
