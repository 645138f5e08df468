package org.u2sa.cli.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.schema.U2SAData;

class SafetyLinesTest {
  private final LocalBus bus = new LocalBus("rover");
  private final LockstepClock clock = new LockstepClock();
  private final List<String> printed = new ArrayList<>();
  private final SafetyLines lines = new SafetyLines(bus, clock, 10.0, printed::add);

  @AfterEach
  void close() {
    lines.close();
  }

  private void deliver(Channel<?> channel, U2SAData message) {
    message.systemId("rover");
    message.timestamp(clock.micros());
    message.freeze();
    bus.deliver(channel, message);
  }

  private void arming(boolean armed, String... reasons) {
    deliver(Channels.ARMING_STATE, new ArmingState().armed(armed).reasons(List.of(reasons)));
  }

  private void failsafe(FailsafeAction action, String... causes) {
    deliver(Channels.FAILSAFE, new FailsafeState().action(action).causes(List.of(causes)));
  }

  private void stop(boolean active, String reason) {
    deliver(
        Channels.EMERGENCY_STOP, new EmergencyStop().active(active).operator("ann").reason(reason));
  }

  @Test
  void receive_emergencyStopThatIsRepeated_isPrintedOnceWithItsReason() {
    arming(true);
    stop(true, "dog on the course");
    arming(false, "emergency stop by \"ann\": dog on the course");
    failsafe(FailsafeAction.STOP);
    stop(true, "dog on the course");
    arming(false, "emergency stop by \"ann\": dog on the course");

    assertThat(printed).containsExactly("emergency stop by \"ann\": dog on the course", "disarmed");
    assertThat(lines.interventions())
        .containsExactly("emergency stop by \"ann\": dog on the course");
  }

  @Test
  void receive_clearAndArming_arePrinted() {
    arming(true);
    stop(true, "dog");
    arming(false);
    stop(false, "gone");
    stop(false, "gone");
    arming(true);

    assertThat(printed)
        .containsExactly(
            "emergency stop by \"ann\": dog",
            "disarmed",
            "emergency stop cleared by \"ann\"",
            "armed again");
  }

  @Test
  void receive_failsafeWhoseCauseCounts_isPrintedOnce() {
    arming(true);
    failsafe(FailsafeAction.CONTINUE);
    failsafe(FailsafeAction.LAND, "geofence: left by 2 m");
    failsafe(FailsafeAction.LAND, "geofence: left by 3 m");
    failsafe(FailsafeAction.CONTINUE);

    assertThat(printed)
        .containsExactly("failsafe LAND because of geofence: left by 2 m", "failsafe ended");
  }

  @Test
  void receive_neverArmed_isPrintedAfterAWhileWithTheReasons() throws InterruptedException {
    arming(false, "position: no state yet");
    assertThat(printed).isEmpty();

    clock.advance(11_000_000);
    arming(false, "low battery: 10.1 V");
    arming(false, "low battery: 10.0 V");

    assertThat(printed).containsExactly("not armed: low battery: 10.1 V");
  }

  @Test
  void receive_armingAtTheStart_isNotPrinted() {
    arming(false, "mission: no goals");
    arming(true);

    assertThat(printed).isEmpty();
  }
}
