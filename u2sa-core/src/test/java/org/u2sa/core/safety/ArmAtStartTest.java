package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.EmergencyStop;

/** ARM AT START arms once in a run: no later Safety Manager undoes a disarming. */
@Timeout(120)
class ArmAtStartTest extends WatchedVehicle {
  @BeforeEach
  void armAtStart() {
    kit.with("ARM AT START", true);
  }

  private SafetyManager startedArmed() {
    SafetyManager manager = start();
    live(1.0);
    assertThat(isArmed()).isTrue();
    return manager;
  }

  private boolean isArmed() {
    return kit.latest(Channels.ARMING_STATE).orElseThrow().armed();
  }

  /** Has all that arming needs. */
  private void liveReady(double seconds) {
    battery(12.5, 80.0);
    actuatorServicesReport();
    kit.publish(
        Channels.ACTUATORS,
        new ActuatorAnnouncement().actuatorName("MOTOR").minimum(0.0).maximum(100.0));
    live(seconds);
    assertThat(kit.latest(Channels.ARMING_STATE).orElseThrow().reasons()).isEmpty();
  }

  private void staysDisarmed() {
    kit.forget();
    liveReady(3.0);
    assertThat(kit.published(Channels.ARMING_STATE)).isNotEmpty().noneMatch(ArmingState::armed);
  }

  @Test
  void restart_afterTheOperatorDisarmed_staysDisarmedAndSaysWhy() {
    SafetyManager manager = startedArmed();
    arm(false);
    kit.restart(manager, SafetyManager::new);

    staysDisarmed();
    assertThat(kit.log("SafetyManager"))
        .anyMatch(line -> line.endsWith("does not arm at start: it was restarted"));
  }

  @Test
  void swap_afterTheOperatorDisarmed_staysDisarmed() {
    SafetyManager manager = startedArmed();
    arm(false);
    kit.swap(manager, SafetyManager::new);

    staysDisarmed();
  }

  @Test
  void restart_afterAStopAndItsClear_staysDisarmed() {
    SafetyManager manager = startedArmed();
    kit.publish(Channels.EMERGENCY_STOP, new EmergencyStop().active(true).stopId("Ann 1"));
    live(0.5);
    kit.publish(Channels.EMERGENCY_STOP, new EmergencyStop().active(false).lifts(List.of("Ann 1")));
    live(0.5);
    kit.restart(manager, SafetyManager::new);

    staysDisarmed();
  }

  @Test
  void restart_withoutSavedState_staysDisarmed() {
    SafetyManager before = kit.start(SafetyManager::new); // has saved nothing yet
    kit.restart(before, SafetyManager::new);
    goals();

    staysDisarmed();
  }

  private void goals() {
    kit.publish(Channels.GOALS, new GoalList().goals(List.of(waypoint())));
  }

  @Test
  void start_shortlyAfterAnotherManagerSpoke_staysDisarmed() {
    startedArmed().kill(); // by a program that starts it again as if for the first time
    start();

    staysDisarmed();
  }

  @Test
  void start_longAfterAnotherManagerSpoke_arms() {
    startedArmed().kill();
    kit.advance(21.0);
    start();
    live(1.0);

    assertThat(isArmed()).isTrue();
  }

  @Test
  void swap_whileItWaitsForTheChecks_armsWhenTheyPass() {
    SafetyManager manager = startManager();
    kit.swap(manager, SafetyManager::new);
    live(1.0);
    assertThat(isArmed()).isFalse();
    goals();
    liveReady(1.0);

    assertThat(isArmed()).isTrue();
  }

  @Test
  void restart_whileArmed_staysArmed() {
    SafetyManager manager = startedArmed();
    kit.restart(manager, SafetyManager::new);
    live(1.0);

    assertThat(isArmed()).isTrue();
  }
}
