package org.u2sa.core.health;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.ConnectionLost;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceAction;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.contract.ServiceOrder;
import org.u2sa.messages.contract.ServiceOrderResult;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.contract.StopCommand;
import org.u2sa.testkit.ServiceKit;

/** What the monitor concludes from reports and their absence, and what it does then. */
@Timeout(30)
class HealthMonitorTest {
  private static final double INTERVAL_S = 0.25;

  private final ServiceKit kit = new ServiceKit();

  @AfterEach
  void close() {
    kit.close();
  }

  private HealthMonitor monitor() {
    return kit.with("WATCHED", "Worker").start(HealthMonitor::new);
  }

  private static HealthReport report(String instance) {
    return new HealthReport()
        .serviceName("Worker")
        .status(ServiceStatus.RUNNING)
        .instance(instance)
        .interval(INTERVAL_S)
        .published(0);
  }

  private void say(HealthReport report) {
    kit.publish(Channels.HEALTH, report);
  }

  /** Reports all is well for a while. */
  private void live(String instance, double forS) {
    for (double s = 0.0; s < forS; s += INTERVAL_S) {
      say(report(instance));
      kit.advance(INTERVAL_S);
    }
  }

  private ServiceCondition condition() {
    return kit.latest(Channels.CONDITIONS).orElseThrow();
  }

  private List<Condition> conditions() {
    return kit.published(Channels.CONDITIONS).stream()
        .map(ServiceCondition::condition)
        .distinct()
        .collect(Collectors.toList());
  }

  private List<ServiceOrder> orders() {
    return kit.published(Channels.SERVICE_ORDERS).stream()
        .filter(ServiceOrder.class::isInstance)
        .map(ServiceOrder.class::cast)
        .collect(Collectors.toList());
  }

  private void answer(ServiceOrder order, boolean accepted) {
    kit.publish(
        Channels.SERVICE_ORDERS,
        new ServiceOrderResult()
            .requestId(order.requestId())
            .serviceName("Worker")
            .accepted(accepted)
            .reason(accepted ? "" : "no device"));
  }

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
  void failed_restartsWaitTwiceAsLongEachTimeAndThenItIsGivenUp() {
    monitor();
    live("0", 1.0);
    double failedS = 0.0;
    for (int restart = 1; restart <= 3; restart++) {
      say(report(String.valueOf(restart - 1)).status(ServiceStatus.FAILED));
      failedS = kit.nowS();
      while (orders().size() < restart) {
        kit.advance(0.05);
      }
      double waitedS = kit.nowS() - failedS;
      assertThat(waitedS).isBetween(0.25 * (1 << (restart - 1)) - 0.01, 0.26 * (1 << restart));
      assertThat(condition().action()).isEqualTo("restart " + restart + " of 3");
      answer(orders().get(restart - 1), true);
      say(report(String.valueOf(restart)));
      kit.advance(0.25);
      assertThat(condition().condition()).isEqualTo(Condition.ALIVE);
    }
    say(report("3").status(ServiceStatus.FAILED));
    kit.advance(100.0);

    assertThat(orders()).hasSize(3);
    assertThat(condition().condition()).isEqualTo(Condition.FAILED);
    assertThat(condition().action()).isEqualTo("failsafe, given up after 3 restarts");
    assertThat(condition().restarts()).isEqualTo(3);
  }

  @Test
  void restart_oldInstanceEndsAndReportsMeanwhile_isNoStop() {
    monitor();
    live("a", 1.0);
    say(report("a").threadAlive(true).callbackRunning(3.0));
    kit.advance(0.5);
    assertThat(orders()).hasSize(1);

    say(report("a").status(ServiceStatus.STOPPED));
    answer(orders().get(0), true);
    live("b", 1.0);
    say(report("a")); // the old thread woke up
    live("b", 0.25);

    assertThat(conditions()).containsExactly(Condition.ALIVE, Condition.HUNG);
    assertThat(condition().condition()).isEqualTo(Condition.ALIVE);
    assertThat(orders()).hasSize(1);
  }

  @Test
  void restart_refused_isTriedAgainLater() {
    monitor();
    live("a", 1.0);
    say(report("a").status(ServiceStatus.FAILED));
    kit.advance(0.5);
    answer(orders().get(0), false);
    kit.advance(1.0);

    assertThat(orders()).hasSize(2);
    assertThat(kit.log("HealthMonitor")).anyMatch(line -> line.contains("no device"));
  }

  @Test
  void restart_nobodyAnswers_isTriedAgainAndGivenUp() {
    kit.with("START WITHIN", 2.0);
    monitor();
    live("a", 1.0);
    say(report("a").status(ServiceStatus.FAILED));
    kit.advance(60.0);

    assertThat(orders()).hasSize(3);
    assertThat(condition().action()).contains("given up");
  }

  @Test
  void policyAlert_isSaidAndNothingElse() {
    kit.with("Worker POLICY", "ALERT");
    monitor();
    live("a", 1.0);
    say(report("a").status(ServiceStatus.FAILED));
    kit.advance(5.0);

    assertThat(condition().action()).isEqualTo("alert");
    assertThat(orders()).isEmpty();
  }

  @Test
  void policyFailsafe_isSaidAtOnce() {
    kit.with("POLICY", "FAILSAFE");
    monitor();
    live("a", 1.0);
    say(report("a").status(ServiceStatus.FAILED));

    assertThat(condition().action()).isEqualTo("failsafe");
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
  void monitorRestarted_knowsWhatTheOneBeforeSaidAndMissesWhatIsGone() {
    HealthMonitor first = monitor();
    live("a", 1.0);
    say(report("a").status(ServiceStatus.FAILED));
    kit.advance(0.5);
    assertThat(orders()).hasSize(1);
    first.kill();
    kit.forget();
    kit.start(HealthMonitor::new);

    kit.advance(20.0);

    assertThat(condition().condition()).isEqualTo(Condition.LOST);
    assertThat(condition().restarts()).isEqualTo(2); // one before it, one of its own
    assertThat(condition().instance()).hasValue("a");
  }

  @Test
  void monitorRestarted_stoppedServiceStaysStopped() {
    HealthMonitor first = monitor();
    live("a", 1.0);
    say(report("a").status(ServiceStatus.STOPPED));
    first.kill();
    kit.start(HealthMonitor::new);

    kit.advance(20.0);

    assertThat(condition().condition()).isEqualTo(Condition.STOPPED);
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
  void restart_spokenForWhileItIsReplaced_isNoNews() {
    monitor();
    live("a", 1.0);
    say(report("a").threadAlive(true).callbackRunning(3.0));
    kit.advance(0.5);
    assertThat(orders()).hasSize(1);

    say(report("a").threadAlive(false)); // its thread ends before its status says so
    kit.advance(0.3);

    assertThat(conditions()).containsExactly(Condition.ALIVE, Condition.HUNG);
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
