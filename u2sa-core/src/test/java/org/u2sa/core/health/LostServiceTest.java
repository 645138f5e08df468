package org.u2sa.core.health;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.ConnectionLost;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceAction;
import org.u2sa.messages.contract.ServiceStatus;

/** What the monitor concludes from silence and from lost connections. */
@Timeout(120)
class LostServiceTest extends WatchedWorker {
  @Test
  void silence_isSilentAfterThreeIntervalsAndLostAfterFourSeconds() {
    monitor();
    live("a", 2.0);
    kit.advance(1.0);
    assertThat(condition().condition()).isEqualTo(Condition.SILENT);
    assertThat(orders()).isEmpty();

    kit.advance(3.0);
    assertThat(condition().condition()).isEqualTo(Condition.LOST);
    kit.advance(0.5);
    assertThat(orders()).hasSize(1);
    assertThat(orders().get(0).action()).isEqualTo(ServiceAction.RESTART);
    assertThat(orders().get(0).serviceName()).isEqualTo("Worker");
  }

  private HealthReport ownReport() {
    return new HealthReport()
        .serviceName("HealthMonitor")
        .status(ServiceStatus.RUNNING)
        .instance("own")
        .interval(INTERVAL_S);
  }

  @Test
  void silence_whenItDoesNotHearEvenItself_judgesNobody() {
    kit.with("HEALTH INTERVAL", 3600.0); // so that it is heard only where this test has it so
    monitor();
    say(ownReport());
    live("a", 0.5);

    kit.advance(20.0);
    assertThat(orders()).isEmpty();
    assertThat(condition().condition()).isIn(Condition.ALIVE, Condition.SILENT);

    hearItselfFor(5.0); // the worker takes longer to come back
    live("a", 0.5);
    assertThat(orders()).isEmpty();
    assertThat(condition().condition()).isEqualTo(Condition.ALIVE);
  }

  @Test
  void silence_longAfterItHearsItselfAgain_isLost() {
    kit.with("HEALTH INTERVAL", 3600.0);
    monitor();
    say(ownReport());
    live("a", 0.5);
    kit.advance(20.0);

    hearItselfFor(12.0);

    assertThat(condition().condition()).isEqualTo(Condition.LOST);
    assertThat(orders()).hasSize(1);
  }

  private void hearItselfFor(double forS) {
    for (double s = 0.0; s < forS; s += INTERVAL_S) {
      say(ownReport());
      kit.advance(INTERVAL_S);
    }
  }

  @Test
  void neverHeard_isLostOnceItsTimeToStartIsOver() {
    kit.with("START WITHIN", 5.0);
    monitor();

    kit.advance(4.9);
    assertThat(kit.published(Channels.CONDITIONS)).isEmpty();
    kit.advance(0.5);
    assertThat(condition().condition()).isEqualTo(Condition.LOST);
  }

  @Test
  void connectionLost_ofThePresentInstance_isLostAtOnce() {
    monitor();
    live("a", 1.0);

    say(new ConnectionLost().serviceName("Worker").status(ServiceStatus.FAILED).instance("a"));

    assertThat(condition().condition()).isEqualTo(Condition.LOST);
    assertThat(condition().reason()).contains("connection");
  }

  @Test
  void connectionLost_ofAFormerInstance_isLeftOut() {
    monitor();
    live("a", 1.0);
    live("b", 1.0);

    say(new ConnectionLost().serviceName("Worker").status(ServiceStatus.FAILED).instance("a"));
    live("b", 1.0);

    assertThat(conditions()).containsExactly(Condition.ALIVE);
  }

  @Test
  void connectionLost_serviceHeardAgainByItself_isAlive() {
    kit.with("RESTART DELAY", 10.0);
    monitor();
    live("a", 1.0);
    say(new ConnectionLost().serviceName("Worker").status(ServiceStatus.FAILED).instance("a"));

    live("a", 1.0);

    assertThat(condition().condition()).isEqualTo(Condition.ALIVE);
    assertThat(orders()).isEmpty();
  }

  private ConnectionLost lost(String instance) {
    ConnectionLost lost = new ConnectionLost();
    lost.serviceName("Worker").status(ServiceStatus.FAILED).instance(instance);
    return lost;
  }

  @Test
  void connectionLost_notHeardAgain_isRestartedOnceItHadItsTimeToReconnect() {
    kit.with("RECONNECT WITHIN", 2.0);
    monitor();
    live("a", 1.0);
    say(lost("a"));
    kit.advance(1.8);
    assertThat(orders()).isEmpty();

    kit.advance(0.5);
    assertThat(orders()).hasSize(1);
  }

  @Test
  void connectionLost_linkIsBackAfterAnAttemptThatHung_isNotRestarted() {
    monitor();
    live("a", 1.0);
    say(lost("a"));

    kit.advance(5.5); // it learns of the break 1 s later, and the attempt hangs for 4 s
    live("a", 1.0);

    assertThat(orders()).isEmpty();
    assertThat(condition().condition()).isEqualTo(Condition.ALIVE);
  }

  @Test
  void connectionLost_processHasEnded_isRestartedAtOnce() {
    kit.with("RECONNECT WITHIN", 60.0).with("RESTART DELAY", 0.0);
    monitor();
    live("a", 1.0);
    say(lost("a"));
    ConnectionLost end = lost("a");
    end.threadAlive(false).lastError("its process has ended with exit code 137");
    say(end);

    assertThat(orders()).hasSize(1);
    assertThat(condition().condition()).isEqualTo(Condition.LOST);
    assertThat(condition().reason()).isEqualTo("its process has ended with exit code 137");
  }

  @Test
  void connectionLost_processHasEndedAndLinkBrokeInTheSameMoment_isRestartedAtOnce() {
    kit.with("RECONNECT WITHIN", 60.0).with("RESTART DELAY", 0.0);
    monitor();
    live("a", 1.0);
    ConnectionLost end = lost("a");
    end.threadAlive(false).lastError("its process has ended with exit code 137");
    kit.send(Channels.HEALTH, end);
    kit.send(Channels.HEALTH, lost("a")); // before the monitor has handled the word above
    kit.settle();

    assertThat(orders()).hasSize(1);
    assertThat(condition().reason()).isEqualTo("its process has ended with exit code 137");
  }
}
