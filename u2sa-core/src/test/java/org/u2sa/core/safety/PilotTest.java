package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.messages.safety.OperatorHeartbeat;

/** Failsafes while a pilot flies by a radio of his own, and when he has given back. */
class PilotTest extends WatchedVehicle {
  @BeforeEach
  void configurePilot() {
    kit.with("PILOT SERVICE", "RadioSensor").with("OPERATOR DEADLINE", 30.0);
    kit.with("LONG OPERATOR DEADLINE", 180.0).with("ON LONG OPERATOR LOSS", "STOP");
  }

  private boolean isConfirmed; // by the radio's health reports
  private boolean radioLives = true;
  private List<String> lost = List.of(); // remark on the radio's loss

  /** As {@link WatchedVehicle#live}, with the health reports of the radio. */
  @Override
  void live(double seconds) {
    for (double t = 0.0; t < seconds - 1e-9; t += 0.2) {
      if (radioLives) {
        HealthReport report = new HealthReport().serviceName("RadioSensor");
        report.status(ServiceStatus.RUNNING).interval(0.25);
        List<String> remarks = new ArrayList<>(lost);
        if (isConfirmed) {
          remarks.add(ManualState.REMARK + ": pilot");
        }
        kit.send(Channels.HEALTH, report.remarks(remarks));
      }
      super.live(Math.min(0.2, seconds - t));
    }
  }

  private void byHand(boolean active) {
    isConfirmed = active;
    kit.publish(Channels.MANUAL_STATE, new ManualState().active(active).operator("pilot"));
  }

  private void hearOperator() {
    kit.publish(Channels.OPERATOR, new OperatorHeartbeat().operator("Ann"));
  }

  @Test
  void step_linkLostWhileAPilotFlies_waitsUntilHeHasGivenBack() {
    startArmed();
    hearOperator();
    byHand(true);
    live(200.0);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
    assertThat(kit.published(Channels.EMERGENCY_STOP)).isEmpty();

    byHand(false);
    live(29.0);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
    live(2.0);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.RETURN);
    live(150.0);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.STOP);
  }

  @Test
  void step_linkLostBeforeHeTakesOver_theReturnWaits() {
    kit.with("RESUME", true);
    startArmed();
    hearOperator();
    live(31.0);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.RETURN);

    byHand(true);
    live(4.0);

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @Test
  void step_batteryCriticalWhileAPilotFlies_isSaidAndActsWhenHeHasGivenBack() {
    startArmed();
    byHand(true);
    battery(12.5, 5.0);
    live(12.0);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
    assertThat(failsafe().causes()).anyMatch(cause -> cause.startsWith("critical battery"));

    byHand(false);
    live(0.3);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.STOP);
  }

  @Test
  void step_radioFailsWhileAPilotFlies_failsafesActAgain() {
    startArmed();
    byHand(true);
    battery(12.5, 5.0);
    live(12.0);

    condition("RadioSensor", Condition.LOST);
    live(0.3);

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.STOP);
  }

  private void radioLost(String who) {
    lost = List.of(ManualState.LOSS_REMARK + ": " + who);
  }

  @Test
  void step_radioLostAtAutomatic_isReportedAndFailsafesAct() {
    startArmed();
    hearOperator();
    byHand(false);
    radioLost("automatic control continues");
    live(1.0);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
    assertThat(failsafe().causes())
        .containsExactly("pilot's radio: lost: automatic control continues");

    live(31.0);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.RETURN);
  }

  @Test
  void step_radioLostAndTheMatrixReturns_returns() {
    kit.with("ON RADIO LOSS", "RETURN");
    startArmed();
    byHand(false);
    radioLost("automatic control continues");
    live(1.0);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.RETURN);
  }

  /** Who flies by hand and is not heard does not stand for an operator who is not heard either. */
  @Test
  void step_radioLostWhileAPilotFlies_operatorsAreMissedWithoutAnActionUntilHeGivesBack() {
    startArmed();
    hearOperator();
    byHand(true);
    live(40.0);
    assertThat(failsafe().causes()).isEmpty();
    radioLost("control stays with the pilot");
    live(32.0);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
    assertThat(failsafe().causes())
        .anyMatch(cause -> cause.startsWith("operator link: "))
        .contains("pilot's radio: lost: control stays with the pilot");
    live(200.0);
    assertThat(kit.published(Channels.EMERGENCY_STOP)).isEmpty();

    byHand(false);
    lost = List.of();
    live(29.0);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
    live(2.0);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.RETURN);
  }

  @Test
  void step_radiosServiceSilent_isReported() {
    startArmed();
    live(1.0);
    assertThat(failsafe().causes()).isEmpty();
    radioLives = false;
    live(2.0);
    assertThat(failsafe().causes()).containsExactly("pilot's radio: RadioSensor sends no reports");
  }

  @Test
  void arm_radioLost_isRefused() {
    start();
    radioLost("automatic control continues");
    live(1.0);
    assertThat(arm(true).reasons())
        .containsExactly("pilot's radio: lost: automatic control continues");
  }

  /** Before the first report of the radio's service, its predecessor knows that a pilot flies. */
  @Test
  void restart_batteryCriticalWhileAPilotFlies_stillWaits() {
    SafetyManager before = startArmedManager();
    byHand(true);
    battery(12.5, 5.0);
    live(12.0);
    before.kill();
    kit.restart(before, SafetyManager::new);
    kit.advance(0.4);

    assertThat(kit.latest(Channels.ARMING_STATE).orElseThrow().armed()).isTrue();
    live(3.0);
    assertThat(kit.published(Channels.EMERGENCY_STOP)).isEmpty();
    assertThat(failsafe().causes()).anyMatch(cause -> cause.startsWith("critical battery"));
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  /** Not everybody who may publish a manual-state is the radio. */
  @Test
  void step_manualStateThatTheRadioDoesNotConfirm_failsafesAct() {
    startArmed();
    byHand(true);
    isConfirmed = false;
    battery(12.5, 5.0);
    live(12.0);

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.STOP);
  }

  /** Without a Health Monitor that would say so. */
  @Test
  void step_radiosServiceDiesWhileAPilotFlies_failsafesActAgain() {
    startArmed();
    byHand(true);
    battery(12.5, 5.0);
    live(12.0);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);

    radioLives = false;
    live(1.4);

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.STOP);
  }

  /** Whoever drives by a station does so through the vehicle's services. */
  @Test
  void step_drivenByHandWithoutSuchARadio_failsafesAct() {
    kit.with("PILOT SERVICE", "");
    startArmed();
    hearOperator();
    byHand(true);
    live(31.0);

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.RETURN);
  }
}
