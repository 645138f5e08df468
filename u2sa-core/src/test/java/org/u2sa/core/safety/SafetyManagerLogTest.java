package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.OperatorHeartbeat;

/** What somebody reads afterwards of arming and failsafes: each change once, and why. */
@Timeout(120)
class SafetyManagerLogTest extends WatchedVehicle {
  /** Level and words of the lines about arming and failsafes. */
  private List<String> told() {
    return kit.log("SafetyManager").stream()
        .map(line -> line.split(" \\| ", 5))
        .map(part -> part[1] + " " + part[4])
        .filter(line -> line.matches(".*(arm|failsafe|emergency).*"))
        .toList();
  }

  @Test
  void arm_refusedThenDone_isToldWithWhoAskedAndWhyNot() {
    start();
    arm(true);
    live(0.3);
    arm(true);
    arm(false);

    assertThat(told())
        .containsExactly(
            "INFO \"Ann\" asks to arm",
            "WARN not armed: position: no state yet",
            "INFO \"Ann\" asks to arm",
            "INFO armed",
            "INFO \"Ann\" asks to disarm",
            "WARN disarmed: by \"Ann\"");
  }

  @Test
  void armAtStart_checksDoNotPass_whyIsToldOnceForEachNumberOfReasons() {
    kit.with("ARM AT START", true).with("MISSION REQUIRED", false);
    startManager();
    live(2.0);
    battery(12.5, 80.0);
    live(2.0);

    assertThat(told())
        .filteredOn(line -> line.contains("waiting to arm"))
        .hasSize(3) // without a state, without a battery, without actuators
        .last()
        .isEqualTo("INFO waiting to arm: actuators: none announced");
  }

  @Test
  void failsafe_beginsAndEnds_isToldOnceEach() {
    startArmed();
    position = false;
    live(5.0);
    position = true;
    live(5.0);

    assertThat(told())
        .filteredOn(line -> line.contains("failsafe"))
        .containsExactly(
            "WARN failsafe HOLD because of [position: state lacks x or y]",
            "INFO failsafe CONTINUE because of []");
  }

  @Test
  void failsafe_anotherCauseOfTheSameAction_isToldAsWell() {
    kit.with("RESUME", true).with("BATTERY TIME", 0.0);
    startArmed();
    kit.publish(Channels.OPERATOR, new OperatorHeartbeat().operator("Ann"));
    live(6.0);
    battery(10.9, 80.0);
    live(1.0);

    assertThat(told())
        .filteredOn(line -> line.contains("failsafe"))
        .containsExactly(
            "WARN failsafe RETURN because of [operator link: \"Ann\" silent for 5.1 s]",
            "WARN failsafe RETURN because of [operator link: \"Ann\" silent for 6.1 s, "
                + "low battery: main, voltage 10.9 below 11.0 V]");
  }

  /** It does not wait for its own stop to come back from a broker that may be away. */
  @Test
  void failsafe_thatStops_disarmsInTheSameStep() {
    kit.with("BATTERY TIME", 0.0);
    startArmed();
    battery(12.5, 9.0);
    live(0.3);

    assertThat(told())
        .containsSubsequence(
            "WARN disarmed: emergency stop by \"SafetyManager\": "
                + "critical battery: main, remaining 9.0 below 10.0 %",
            "WARN failsafe STOP because of "
                + "[critical battery: main, remaining 9.0 below 10.0 %]");
  }

  @Test
  void emergencyStop_ordered_isToldAsTheCause() {
    startArmed();
    kit.publish(Channels.EMERGENCY_STOP, new EmergencyStop().active(true).stopId("Ann 1"));
    live(0.3);

    assertThat(told()).contains("WARN failsafe STOP because of a stop order");
  }

  @Test
  void emergencyStop_cleared_isToldWithWhoClearedIt() {
    startArmed();
    kit.publish(Channels.EMERGENCY_STOP, new EmergencyStop().active(true).stopId("Ann 1"));
    kit.publish(
        Channels.EMERGENCY_STOP,
        new EmergencyStop().active(false).lifts(List.of("Ann 1")).operator("Bob"));

    assertThat(told()).contains("INFO emergency stop cleared by \"Bob\"");
  }
}
