package org.u2sa.core.health;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.contract.StopCommand;

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
  void launcherSpeaks_threadEnded_isDead() {
    monitor();
    live("a", 1.0);

    say(report("a").threadAlive(false));

    assertThat(condition().condition()).isEqualTo(Condition.DEAD);
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
