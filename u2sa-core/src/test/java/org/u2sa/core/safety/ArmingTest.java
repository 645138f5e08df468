package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.service.actuator.EmergencyLatch;
import org.u2sa.testkit.ServiceKit;

/** What must be there before the vehicle is armed. */
@Timeout(120)
class ArmingTest extends WatchedVehicle {
  @Test
  void arm_everythingThere_armsAndAnswers() {
    startArmed();

    assertThat(arm(true).reasons()).isEmpty();
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @Test
  void arm_nothingThere_saysAllReasons() {
    kit.with("OPERATOR REQUIRED", true).with("HEALTH MONITOR REQUIRED", true);
    kit.with("ON FENCE", "LAND");
    startManager();
    condition("PathPlanner", Condition.HUNG);

    ArmingState state = arm(true);

    assertThat(state.armed()).isFalse();
    assertThat(state.requestId()).contains("7");
    assertThat(state.reasons())
        .containsExactly(
            "service PathPlanner is HUNG: seen so",
            "operator link: no operator heard",
            "position: no state yet",
            "health monitor: no HealthMonitor heard",
            "low battery: a threshold is set, but no battery heard",
            "critical battery: a threshold is set, but no battery heard",
            "mission: no goals",
            "actuators: none announced",
            "failsafe matrix: ON FENCE is LAND, but no Mission Manager has reported a loaded LAND MISSION");
  }

  @Test
  void arm_noPositionAndNoneRequired_isNoReason() {
    kit.with("POSITION REQUIRED", false);
    startManager();

    assertThat(arm(true).reasons()).isNotEmpty().noneMatch(words -> words.startsWith("position"));
  }

  @Test
  void arm_failedServiceThatIsWatchedNoMore_doesNotCount() {
    start();
    live(0.3);
    condition("Camera", Condition.FAILED);
    assertThat(arm(true).reasons()).containsExactly("service Camera is FAILED: seen so");

    condition("Camera", Condition.UNWATCHED);

    assertThat(arm(true).armed()).isTrue();
  }

  @Test
  void arm_actuatorThatEnded_isNotThere() {
    start();
    live(15.0);
    assertThat(arm(true).armed()).isTrue(); // who announces every 5 s may be late twice
    arm(false);

    live(1.0);

    assertThat(arm(true).reasons()).containsExactly("actuators: none announced");
  }

  @Test
  void arm_actuatorThatIsWithdrawn_isNotThere() {
    start();
    live(0.3);
    kit.publish(
        Channels.ACTUATORS,
        new ActuatorAnnouncement()
            .actuatorName("MOTOR")
            .minimum(0.0)
            .maximum(100.0)
            .available(0.0));

    assertThat(arm(true).reasons()).containsExactly("actuators: none announced");
  }

  @Test
  void clear_thatLiftsNothing_leavesTheStopForWhoComesLate() {
    startArmed();
    EmergencyStop stop = new EmergencyStop().active(true).operator("Ann").stopId("Ann 1");
    kit.publish(Channels.EMERGENCY_STOP, stop);
    kit.publish(Channels.EMERGENCY_STOP, new EmergencyStop().active(false).clears(-1));

    assertThat(kit.latest(Channels.EMERGENCY_STOP)).contains(stop);
    live(0.2);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.STOP);
    assertThat(arm(true).reasons())
        .anyMatch(reason -> reason.contains("emergency stop by \"Ann\""));
  }

  @Test
  void clear_ofOneOfTwoStops_isStoppedByTheOther() {
    startArmed();
    kit.publish(Channels.EMERGENCY_STOP, new EmergencyStop().active(true).stopId("Ann 1"));
    EmergencyStop other = new EmergencyStop().active(true).stopId("Bob 1").operator("Bob");
    kit.publish(Channels.EMERGENCY_STOP, other);

    kit.publish(Channels.EMERGENCY_STOP, new EmergencyStop().active(false).lifts(List.of("Ann 1")));
    live(0.2);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.STOP);
    assertThat(kit.latest(Channels.EMERGENCY_STOP)).contains(other);

    kit.publish(Channels.EMERGENCY_STOP, new EmergencyStop().active(false).lifts(List.of("Bob 1")));
    live(0.3);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @Test
  void arm_outsideTheFenceUncertainAndLow_saysSoWithTheValues(@TempDir Path directory)
      throws IOException {
    Path fence = directory.resolve("fence.xml");
    String text =
        "<fence><reference>Local ENU</reference><keepIn><corner><x>10</x><y>10</y></corner>"
            + "<corner><x>90</x><y>10</y></corner><corner><x>90</x><y>90</y></corner></keepIn></fence>";
    Files.write(fence, text.getBytes(StandardCharsets.UTF_8));
    kit.with("FENCE", fence.toString()).with("REQUIRED ACTUATORS", "MOTOR, RUDDER");
    start();
    battery(10.5, 80.0);
    sigmaM = 60.0;
    live(0.3);

    assertThat(arm(true).reasons())
        .containsExactly(
            "position: uncertain by 60 m, limit 50 m",
            "low battery: main, voltage 10.5 below 11.0 V",
            "geofence: outside the keep-in area, or inside a keep-out one",
            "actuators: missing: RUDDER");
  }

  @Test
  void armAtStart_checksPassLater_armsOnceByItself() {
    kit.with("ARM AT START", true);
    start();
    assertThat(kit.latest(Channels.ARMING_STATE).orElseThrow().armed()).isFalse();

    live(0.3);
    assertThat(kit.latest(Channels.ARMING_STATE).orElseThrow().armed()).isTrue();
    arm(false);
    live(1.0);

    assertThat(kit.latest(Channels.ARMING_STATE).orElseThrow().armed()).isFalse();
  }

  private long secondsAgo(double seconds) {
    return kit.clock().micros() - Clock.micros(seconds);
  }

  /** A bridge to an outside broker keeps orders while the link is down. */
  @Test
  void arm_orderOlderThanItsExpiry_isRefusedAndDisarmingIsNot() {
    start();
    live(1.0);
    ArmCommand late = armCommand(true);
    late.timestamp(secondsAgo(20.0));
    ArmingState refused = arm(late);

    assertThat(refused.armed()).isFalse();
    assertThat(refused.requestId()).contains("7");
    assertThat(refused.reasons())
        .singleElement()
        .asString()
        .startsWith("the order arrived 20.")
        .endsWith("give it again (if it was given just now, the clocks differ)");
    ArmCommand inTime = armCommand(true);
    inTime.timestamp(secondsAgo(4.5));
    assertThat(arm(inTime).armed()).isTrue();
    ArmCommand disarm = armCommand(false);
    disarm.timestamp(secondsAgo(29.0));
    assertThat(arm(disarm).armed()).isFalse();
  }

  @Test
  void arm_withoutExpiryOfOrders_countsWheneverItArrives() {
    kit.with("ORDER EXPIRY", 0.0);
    start();
    live(1.0);
    ArmCommand late = armCommand(true);
    late.timestamp(secondsAgo(29.0));

    assertThat(arm(late).armed()).isTrue();
  }

  /** At QoS 1 a message may arrive twice. */
  @Test
  void arm_orderThatArrivesAgainAfterDisarming_doesNotArmAgain() {
    start();
    live(0.3);
    ArmCommand command = armCommand(true);
    assertThat(arm(command).armed()).isTrue();
    assertThat(arm(false).armed()).isFalse();
    kit.forget();

    ArmingState again = arm(command);

    assertThat(again.armed()).isFalse();
    assertThat(again.requestId()).contains(command.requestId());
    assertThat(kit.published(Channels.ARMING_STATE)).noneMatch(ArmingState::armed);
  }

  @Test
  void arm_orderWithoutTimeThatArrivesAgain_doesNotArmAgain() {
    start();
    live(0.3);
    assertThat(arm(timeless("A1")).armed()).isTrue();
    assertThat(arm(false).armed()).isFalse();
    for (int i = 0; i < 100; i++) {
      arm(armCommand(false).requestId("off " + i));
    }

    ArmingState again = arm(timeless("A1"));

    assertThat(again.armed()).isFalse();
    assertThat(again.reasons())
        .containsExactly("this order was answered before: give it under another ID");
    live(1.0);
    assertThat(arm(timeless("A1")).armed()).isFalse();
    assertThat(arm(timeless("A2")).armed()).isTrue();
  }

  private static ArmCommand timeless(String requestId) {
    ArmCommand command = new ArmCommand().requestId(requestId).arm(true).operator("Ann");
    command.systemId(ServiceKit.SYSTEM_ID);
    command.freeze();
    return command;
  }

  /** As of a program that uses one ID for all. */
  @Test
  void disarm_idOfAnEarlierOrder_isObeyed() {
    start();
    live(0.3);
    ArmCommand armed = armCommand(true);
    assertThat(arm(armed).armed()).isTrue();
    ArmCommand disarm = armCommand(false).requestId(armed.requestId());
    assertThat(arm(disarm).armed()).isFalse();
    assertThat(arm(armCommand(true)).armed()).isTrue();

    assertThat(arm((ArmCommand) disarm.copy()).armed()).isFalse();
    ArmCommand other = armCommand(true);
    assertThat(arm(other).armed()).isTrue();
    assertThat(arm(false).armed()).isFalse();
    ArmCommand again = armCommand(true).requestId(other.requestId());
    assertThat(arm(again).armed()).as("given again under its ID").isTrue();
  }

  @Test
  void clear_olderThanItsExpiry_leavesTheStopInForceEverywhere() {
    startArmed();
    live(1.0);
    EmergencyStop stop = new EmergencyStop().active(true).operator("Ann").stopId("Ann 1");
    kit.publish(Channels.EMERGENCY_STOP, stop);
    live(6.0);
    EmergencyLatch actuator = new EmergencyLatch(kit.clock(), ServiceKit.SYSTEM_ID);
    actuator.accept(stop);
    EmergencyStop clear = new EmergencyStop().active(false).operator("Ann").lifts(List.of("Ann 1"));
    clear.timestamp(secondsAgo(5.5));
    actuator.accept(clear);
    kit.forget();
    kit.publish(Channels.EMERGENCY_STOP, clear);
    kit.published(Channels.EMERGENCY_STOP).forEach(actuator::accept);

    assertThat(actuator.isStopped()).isTrue();
    assertThat(arm(true).reasons()).isNotEmpty();
    kit.publish(
        Channels.EMERGENCY_STOP,
        new EmergencyStop().active(false).operator("Ann").lifts(List.of("Ann 1")));
    live(0.3);
    assertThat(arm(true).reasons()).isEmpty();
  }
}
