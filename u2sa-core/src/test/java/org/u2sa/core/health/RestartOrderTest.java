package org.u2sa.core.health;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.ServiceOrder;
import org.u2sa.messages.contract.ServiceStatus;

/** What the monitor does about what it concluded, and remembers when it is itself restarted. */
@Timeout(120)
class RestartOrderTest extends WatchedWorker {
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
  void restartByAPerson_oldInstanceEndedAndNoNewOneStarts_isAFailureThatIsRestarted() {
    monitor();
    live("a", 1.0);
    say(report("a").status(ServiceStatus.STOPPED));
    kit.advance(0.5);
    assertThat(condition().condition()).isEqualTo(Condition.STOPPED);

    answer(new ServiceOrder().requestId("Ann 1"), false);
    kit.advance(1.0);

    assertThat(condition().condition()).isEqualTo(Condition.FAILED);
    assertThat(condition().reason()).isEqualTo("its restart failed: no device");
    assertThat(orders()).hasSize(1);
  }

  @Test
  void restartByAPerson_refusedWhileItRuns_laterStopIsAStop() {
    monitor();
    live("a", 1.0);
    answer(new ServiceOrder().requestId("Ann 1"), false);
    live("a", 1.0);
    say(report("a").status(ServiceStatus.STOPPED));
    kit.advance(1.0);

    assertThat(condition().condition()).isEqualTo(Condition.STOPPED);
    assertThat(orders()).isEmpty();
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
}
