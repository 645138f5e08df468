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
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.FailsafeAction;

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
}
