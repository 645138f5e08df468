package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.u2sa.examples.LeakCheck;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.OperatorHeartbeat;

/** A failsafe that does not latch outlives the Safety Manager until its cause is gone. */
@Timeout(120)
class SafetyManagerSuccessorTest extends WatchedVehicle {
  private enum How {
    RESTART,
    SWAP
  }

  private void succeed(How how, SafetyManager manager) {
    kit.forget();
    if (how == How.RESTART) {
      kit.restart(manager, SafetyManager::new);
    } else {
      kit.swap(manager, SafetyManager::new);
    }
  }

  /** In HOLD now, and for a minute after the succession. */
  private void holdsBeyond(How how, SafetyManager manager) {
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.HOLD);
    succeed(how, manager);
    live(60.0);

    assertThat(kit.published(Channels.FAILSAFE))
        .hasSizeGreaterThan(50)
        .allMatch(state -> state.action() == FailsafeAction.HOLD);
  }

  private void beat() {
    kit.publish(Channels.OPERATOR, new OperatorHeartbeat().operator("Ann").interval(1.0));
  }

  private void silentOperator() {
    beat();
    live(5.3);
  }

  @ParameterizedTest
  @EnumSource
  void hold_forASilentOperator_outlivesTheManagerUntilHeardAgain(How how) {
    kit.with("ON OPERATOR LOSS", "HOLD");
    SafetyManager manager = startArmedManager();
    silentOperator();
    holdsBeyond(how, manager);

    beat();
    live(3.3);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @ParameterizedTest
  @EnumSource
  void hold_twiceInARow_outlivesBoth(How how) {
    kit.with("ON OPERATOR LOSS", "HOLD");
    SafetyManager manager = startArmedManager();
    silentOperator();
    SafetyManager second =
        how == How.RESTART
            ? kit.restart(manager, SafetyManager::new)
            : kit.swap(manager, SafetyManager::new);
    live(1.0);

    holdsBeyond(how, second);
  }

  @ParameterizedTest
  @EnumSource
  void return_withResume_outlivesTheManager(How how) {
    kit.with("RESUME", true);
    SafetyManager manager = startArmedManager();
    silentOperator();
    succeed(how, manager);
    live(20.0);

    assertThat(kit.published(Channels.FAILSAFE))
        .isNotEmpty()
        .allMatch(state -> state.action() == FailsafeAction.RETURN);
  }

  @Test
  void swap_whileTheOperatorIsSilent_keepsTheTime() {
    SafetyManager manager = startArmedManager();
    beat();
    live(4.0);
    succeed(How.SWAP, manager);
    live(0.8);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
    live(0.4);

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.RETURN);
  }

  @ParameterizedTest
  @EnumSource
  void hold_forASilentHealthMonitor_outlivesTheManager(How how) {
    kit.with("ON HEALTH MONITOR LOSS", "HOLD");
    SafetyManager manager = startArmedManager();
    kit.publish(
        Channels.HEALTH,
        new HealthReport().serviceName("HealthMonitor").status(ServiceStatus.RUNNING));
    live(4.3);

    holdsBeyond(how, manager);
  }

  @ParameterizedTest
  @EnumSource
  void hold_forALowBattery_outlivesTheManager(How how) {
    kit.with("ON LOW BATTERY", "HOLD");
    SafetyManager manager = startArmedManager();
    battery(10.9, 80.0);
    live(10.3);

    holdsBeyond(how, manager);
  }

  @ParameterizedTest
  @EnumSource
  void hold_forASilentBattery_outlivesTheManager(How how) {
    kit.with("BATTERY DEADLINE", 10.0).with("ON BATTERY SENSOR LOSS", "HOLD");
    SafetyManager manager = startArmedManager();
    live(11.0);

    holdsBeyond(how, manager);
  }

  @ParameterizedTest
  @EnumSource
  void hold_forActuatorsThatRefuse_outlivesTheManagerUntilTheyObey(How how) {
    SafetyManager manager = startArmedManager();
    long refused = refuse(0, 30);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.HOLD);
    succeed(how, manager);
    refuse(refused, 60);

    assertThat(kit.published(Channels.FAILSAFE))
        .hasSizeGreaterThan(5)
        .allMatch(state -> state.action() == FailsafeAction.HOLD);
    assertThat(failsafe().causes().get(0)).contains("refuses all commands");
  }

  /** Reports of a motor that refuses every command, and returns how many it has refused. */
  private long refuse(long before, int reports) {
    for (int i = 1; i <= reports; i++) {
      kit.publish(
          Channels.HEALTH,
          new HealthReport()
              .serviceName("Motor")
              .instance("1")
              .status(ServiceStatus.RUNNING)
              .commandsObeyed(7)
              .commandsRefused(before + i));
      live(0.1);
    }
    return before + reports;
  }

  @ParameterizedTest
  @EnumSource
  void hold_forAnExtensionsCheck_outlivesTheManagerUntilItHearsSomething(How how) {
    kit.with("ON LEAK", "HOLD");
    SafetyManager manager = startArmedManager();
    bilge(new StateInformation().z(0.02));
    live(0.2);
    holdsBeyond(how, manager);

    bilge(new StateInformation().z(0.0));
    live(3.3);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @ParameterizedTest
  @EnumSource
  void hold_forACheckThatThrew_outlivesTheManager(How how) {
    kit.with("ON LEAK", "HOLD");
    SafetyManager manager = startArmedManager();
    bilge(new StateInformation()); // without the depth that it expects
    live(0.2);

    holdsBeyond(how, manager);
  }

  private void bilge(StateInformation depth) {
    kit.publish(LeakCheck.BILGE, depth.sensorName("bilge"));
  }

  @Test
  void swap_betweenTwoStates_knowsWhereTheVehicleIs() {
    SafetyManager manager = startArmedManager();
    live(1.0);
    succeed(How.SWAP, manager);
    kit.advance(0.7);

    assertThat(kit.published(Channels.FAILSAFE))
        .isNotEmpty()
        .allMatch(state -> state.action() == FailsafeAction.CONTINUE)
        .allMatch(state -> state.causes().equals(List.of()));
  }
}
