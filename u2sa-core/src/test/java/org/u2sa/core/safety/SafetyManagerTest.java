package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.OperatorHeartbeat;

/** Which failsafe follows from what is lost, and when it is over. */
@Timeout(120)
class SafetyManagerTest extends WatchedVehicle {
  @Test
  void failsafe_notArmed_isContinueWhateverIsWrong() {
    startManager();
    kit.advance(2.0);

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @Test
  void rate_atWhichCausesWouldBeNoticedTooLate_isRefused() {
    SafetyManager manager = startManager();

    assertThat(manager.setVariable("RATE", 0.001)).isFalse();
    assertThat(kit.log("SafetyManager")).anyMatch(line -> line.contains("outside 1…10000 Hz"));
  }

  @Test
  void operator_neverHeard_isNotMissed() {
    startArmed();
    live(8.0);

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @Test
  void operator_lost_returnsAfterItsDeadlineAndGoesOnUntilArmedAnew() {
    startArmed();
    kit.publish(Channels.OPERATOR, new OperatorHeartbeat().operator("Ann"));
    live(4.9);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
    live(0.3);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.RETURN);
    assertThat(failsafe().causes()).singleElement().asString().startsWith("operator link: \"Ann\"");

    kit.publish(Channels.OPERATOR, new OperatorHeartbeat().operator("Ann"));
    live(4.5);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.RETURN);
    assertThat(failsafe().causes().get(0)).contains("over; stays until armed again");
    kit.publish(Channels.OPERATOR, new OperatorHeartbeat().operator("Ann"));
    arm(true);
    live(0.2);

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @Test
  void operator_lostAndBackWithResume_continuesAfterTheCauseWasGoneForAWhile() {
    kit.with("RESUME", true);
    startArmed();
    kit.publish(Channels.OPERATOR, new OperatorHeartbeat().operator("Ann"));
    live(5.3);
    kit.publish(Channels.OPERATOR, new OperatorHeartbeat().operator("Ann"));

    live(2.8);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.RETURN);
    live(0.4);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @Test
  void position_uncertainOrAbsentOrStale_holdsAndContinuesWhenItIsBack() {
    startArmed();
    sigmaM = 51.0;
    live(0.2);
    assertThat(failsafe().causes()).containsExactly("position: uncertain by 51 m, limit 50 m");
    sigmaM = 1.0;
    position = false;
    live(3.5);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.HOLD);
    assertThat(failsafe().causes()).containsExactly("position: state lacks x or y");
    position = true;
    live(3.3);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);

    kit.advance(1.3);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.HOLD);
    assertThat(failsafe().causes().toString()).contains("old", "state estimator: no fresh states");
  }

  @Test
  void estimatorAndActuatorLink_byTheMonitorsWord_hold() {
    startArmed();
    condition("StateEstimator", Condition.STALLED);
    condition("Rudder", Condition.LOST);
    live(0.2);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.HOLD);
    assertThat(failsafe().causes())
        .containsExactly(
            "state estimator: service StateEstimator is STALLED: seen so",
            "actuator link: service Rudder is LOST: seen so");

    condition("StateEstimator", Condition.ALIVE);
    condition("Rudder", Condition.SILENT);
    live(3.2);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @Test
  void service_givenUpByTheMonitor_holdsAndOneThatIsRestartedDoesNot() {
    startArmed();
    kit.publish(Channels.CONDITIONS, given("PathPlanner", Condition.DEAD).action("restart 1 of 3"));
    live(0.2);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);

    kit.publish(
        Channels.CONDITIONS,
        given("PathPlanner", Condition.DEAD).action("failsafe, given up after 3 restarts"));
    live(0.2);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.HOLD);
    assertThat(failsafe().causes())
        .containsExactly("service given up: service PathPlanner is DEAD: seen so");

    kit.publish(
        Channels.CONDITIONS,
        given("PathPlanner", Condition.ALIVE).action("failsafe, given up after 3 restarts"));
    live(3.2);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @Test
  void monitor_silent_isACauseByWhichTheVehicleContinues() {
    startArmed();
    kit.publish(
        Channels.HEALTH,
        new HealthReport().serviceName("HealthMonitor").status(ServiceStatus.RUNNING));
    live(4.3);

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
    assertThat(failsafe().causes())
        .singleElement()
        .asString()
        .startsWith("health monitor: HealthMonitor silent for 4.");
  }

  @Test
  void battery_lowForItsTimeOnly_returnsThenCriticalStops() {
    startArmed();
    battery(10.9, 80.0);
    live(9.5);
    battery(11.2, 80.0); // it was a load
    live(0.2);
    battery(10.9, 80.0);
    live(9.7);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
    live(0.5);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.RETURN);

    battery(10.9, 9.0);
    live(10.3);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.STOP);
    EmergencyStop stop = kit.latest(Channels.EMERGENCY_STOP).orElseThrow();
    assertThat(stop.active()).isTrue();
    assertThat(stop.reason()).startsWith("critical battery: main, remaining 9.0 below 10.0 %");
  }

  @Test
  void emergencyStop_isRepeatedWhileItHoldsDisarmsAndIsClearedForGood() {
    startArmed();
    EmergencyStop stop = new EmergencyStop().active(true).operator("Ann").reason("smoke");
    kit.publish(Channels.EMERGENCY_STOP, stop);
    live(3.0);
    assertThat(kit.published(Channels.EMERGENCY_STOP)).hasSizeBetween(2, 4).allMatch(stop::equals);
    assertThat(arm(true).reasons()).contains("emergency stop by \"Ann\": smoke");
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.STOP);

    kit.forget();
    EmergencyStop clear =
        new EmergencyStop().active(false).clears(stop.timestamp().orElseThrow()).operator("Ann");
    kit.publish(Channels.EMERGENCY_STOP, clear);
    live(3.0);

    assertThat(kit.published(Channels.EMERGENCY_STOP)).hasSize(1).allMatch(clear::equals);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
    assertThat(arm(true).armed()).isTrue();
  }

  @Test
  void failsafe_unchanged_isRepeatedSlowly() {
    startArmed();
    kit.forget();
    live(5.0);

    assertThat(kit.published(Channels.FAILSAFE)).hasSize(5);
    assertThat(kit.published(Channels.ARMING_STATE)).hasSize(5);
  }

  /** An outside broker may deliver the last ones of an operator who has gone once more. */
  @Test
  void operator_lateHeartbeats_doNotEndTheFailsafe() {
    startArmed();
    OperatorHeartbeat last = new OperatorHeartbeat().operator("Ann");
    kit.publish(Channels.OPERATOR, last);
    live(6.0);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.RETURN);

    for (int i = 0; i < 5; i++) {
      kit.publish(Channels.OPERATOR, last);
      live(1.0);
    }

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.RETURN);
    assertThat(kit.log("SafetyManager"))
        .anyMatch(line -> line.contains("ignored a heartbeat of \"Ann\" (4 so far)"));
  }

  /** As of a vehicle that has got the right time since, or of a laptop that was asleep. */
  @ParameterizedTest
  @ValueSource(doubles = {-3_600.0, 3_600.0})
  void operator_wrongClock_isHeardAndMissed(double clockAheadS) {
    startArmed();
    for (int i = 0; i < 8; i++) {
      OperatorHeartbeat heartbeat = new OperatorHeartbeat().operator("Ann");
      heartbeat.timestamp(kit.clock().micros() + Clock.micros(clockAheadS));
      kit.publish(Channels.OPERATOR, heartbeat);
      live(1.0);
    }
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);

    live(6.0);

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.RETURN);
  }
}
