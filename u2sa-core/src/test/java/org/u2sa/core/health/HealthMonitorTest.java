package org.u2sa.core.health;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.ConfigurationChange;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.StopCommand;

/** What the monitor concludes from what is reported. */
@Timeout(120)
class HealthMonitorTest extends WatchedWorker {
  @Test
  void launcherSpeaks_callbackRunsLong_isHung() {
    monitor();
    live("a", 1.0);
    say(report("a").threadAlive(true).callbackRunning(1.0));
    assertThat(condition().condition()).isEqualTo(Condition.ALIVE);

    say(report("a").threadAlive(true).callbackRunning(2.5));

    assertThat(condition().condition()).isEqualTo(Condition.HUNG);
    assertThat(condition().reason()).contains("2.5 s");
  }

  @Test
  void launcherSpeaks_threadStandsOutsideOfCallbacks_isHungInTheEnd() {
    monitor();
    live("a", 1.0);

    for (int i = 0; i < 20; i++) { // 5 s
      say(report("a").threadAlive(true));
      kit.advance(INTERVAL_S);
    }

    assertThat(condition().condition()).isEqualTo(Condition.HUNG);
    assertThat(condition().reason()).contains("not come back");
  }

  @Test
  void watched_narrowedInARun_takesBackWhatWasSaid() {
    HealthMonitor monitor = monitor();
    live("a", 1.0);
    say(report("a").status(ServiceStatus.FAILED));
    assertThat(condition().condition()).isEqualTo(Condition.FAILED);

    kit.publish(
        Channels.CONFIGURATION,
        new ConfigurationChange()
            .serviceName("HealthMonitor")
            .variableName("WATCHED")
            .value("PathPlanner"));

    assertThat(monitor.getVariable("WATCHED")).isEqualTo("PathPlanner");
    assertThat(kit.published(Channels.CONDITIONS))
        .filteredOn(condition -> condition.serviceName().equals("Worker"))
        .last()
        .satisfies(last -> assertThat(last.condition()).isEqualTo(Condition.UNWATCHED));
  }

  @Test
  void watched_nameLongerThanMessagesCarry_isRefusedAndTheServicesStayWatched() {
    HealthMonitor monitor = monitor();
    live("a", 1.0);

    kit.publish(
        Channels.CONFIGURATION,
        new ConfigurationChange()
            .serviceName("HealthMonitor")
            .variableName("WATCHED")
            .value("A".repeat(256)));

    assertThat(monitor.getVariable("WATCHED")).isEqualTo("Worker");
    say(report("a").status(ServiceStatus.FAILED));
    assertThat(condition().condition()).isEqualTo(Condition.FAILED);
  }

  @Test
  void watched_nameThatHasNotReported_isRefusedWhileArmed() {
    HealthMonitor monitor = monitor();
    live("a", 1.0);
    assertThat(monitor.setVariable("WATCHED", "Worker, Nobody")).isTrue();
    assertThat(monitor.setVariable("WATCHED", "Worker")).isTrue();

    kit.publish(Channels.ARMING_STATE, new ArmingState().armed(true));

    assertThat(monitor.setVariable("WATCHED", "Worker, Nobody")).isFalse();
    assertThat(kit.log("HealthMonitor"))
        .anyMatch(line -> line.contains("WATCHED: \"Nobody\" has not reported"));
    assertThat(monitor.setVariable("WATCHED", "")).isTrue();
    assertThat(monitor.setVariable("WATCHED", "Worker")).isTrue();
  }

  @Test
  void rate_atWhichFailuresWouldBeNoticedTooLate_isRefused() {
    HealthMonitor monitor = monitor();

    assertThat(monitor.setVariable("RATE", 0.001)).isFalse();
    assertThat(kit.log("HealthMonitor")).anyMatch(line -> line.contains("outside 1…10000 Hz"));
  }

  @Test
  void watched_narrowedBeforeAStart_takesBackWhatTheMonitorBeforeSaid() {
    kit.publish(
        Channels.CONDITIONS,
        new ServiceCondition().serviceName("Camera").condition(Condition.FAILED));

    monitor();

    assertThat(condition().serviceName()).isEqualTo("Camera");
    assertThat(condition().condition()).isEqualTo(Condition.UNWATCHED);
  }

  @Test
  void launcherSpeaks_threadEnded_isDead() {
    monitor();
    live("a", 1.0);

    say(report("a").threadAlive(false));

    assertThat(condition().condition()).isEqualTo(Condition.DEAD);
  }

  private void liveAhead(double aheadS, double forS) {
    for (double s = 0.0; s < forS; s += INTERVAL_S) {
      HealthReport report = report("a");
      report.timestamp(kit.clock().micros() + Math.round(aheadS * 1e6));
      say(report);
      kit.advance(INTERVAL_S);
    }
  }

  private Optional<String> troubleOfTheMonitor() {
    return kit.published(Channels.HEALTH).stream()
        .filter(report -> report.serviceName().equals("HealthMonitor"))
        .reduce((before, last) -> last)
        .flatMap(HealthReport::lastError);
  }

  @Test
  void reports_stampedAnHourAhead_monitorSaysWhoseClockItIs() {
    monitor();
    liveAhead(0.0, 3.0);
    assertThat(troubleOfTheMonitor()).isEmpty();

    liveAhead(3600.0, 5.0);

    assertThat(troubleOfTheMonitor()).hasValue("the clock of Worker is 3600.0 s ahead of this one");
    assertThat(kit.log("HealthMonitor")).filteredOn(line -> line.contains("clock of")).hasSize(1);

    liveAhead(0.0, 5.0);

    assertThat(troubleOfTheMonitor()).hasValue("the clock of Worker agrees again");
  }

  @Test
  void reports_someDelayedForLong_clockIsNotTakenToBeBehind() {
    monitor();
    for (int i = 0; i < 10; i++) {
      liveAhead(-3.0, 1.0);
      liveAhead(0.0, INTERVAL_S);
    }

    assertThat(troubleOfTheMonitor()).isEmpty();
  }

  @Test
  void reports_withoutData_isStalled() {
    kit.with("Worker DATA TIMEOUT", 1.0);
    monitor();
    live("a", 0.5);
    say(report("a").published(7).dataAge(0.9));
    assertThat(condition().condition()).isEqualTo(Condition.ALIVE);

    say(report("a").published(7).dataAge(1.1));
    kit.advance(0.25);

    assertThat(condition().condition()).isEqualTo(Condition.STALLED);
  }

  @Test
  void reports_neverAnyData_isStalled() {
    kit.with("Worker DATA TIMEOUT", 1.0);
    monitor();

    live("a", 1.75);

    assertThat(conditions()).containsExactly(Condition.ALIVE, Condition.STALLED);
  }

  @Test
  void stopped_isLeftAlone() {
    monitor();
    live("a", 1.0);

    say(report("a").status(ServiceStatus.STOPPED));
    kit.advance(10.0);

    assertThat(condition().condition()).isEqualTo(Condition.STOPPED);
    assertThat(orders()).isEmpty();
  }

  @Test
  void stopCommand_thenSilence_isStoppedAndLeftAlone() {
    monitor();
    live("a", 1.0);

    kit.publish(Channels.STOP, new StopCommand().serviceName("Worker"));
    kit.advance(10.0);

    assertThat(condition().condition()).isEqualTo(Condition.STOPPED);
    assertThat(orders()).isEmpty();
  }

  @Test
  void serviceNotWatched_isLeftOut() {
    monitor();
    say(report("a").serviceName("Screen").status(ServiceStatus.FAILED));
    kit.advance(5.0);

    assertThat(kit.published(Channels.CONDITIONS)).isEmpty();
  }

  @Test
  void saidToBeDead_butReportsForItself_isAlive() {
    kit.with("RESTART DELAY", 10.0);
    monitor();
    live("a", 1.0);
    say(report("a").threadAlive(false));
    kit.advance(0.3);
    assertThat(condition().condition()).isEqualTo(Condition.DEAD);

    live("a", 0.5);

    assertThat(condition().condition()).isEqualTo(Condition.ALIVE);
    assertThat(orders()).isEmpty();
  }
}
