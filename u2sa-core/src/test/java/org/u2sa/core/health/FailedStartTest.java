package org.u2sa.core.health;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.core.launch.ProcessFailure;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.ConnectionLost;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;

/** What the monitor does about processes that end before their service reports, or never start. */
@Timeout(120)
class FailedStartTest extends WatchedWorker {
  private static final String NO_FILES =
      ProcessFailure.notStarted(
          new IOException("Cannot run program \"java\": error=24, Too many open files"));

  private static HealthReport processEnded(int exitCode) {
    return new ConnectionLost()
        .serviceName("Worker")
        .status(ServiceStatus.FAILED)
        .lastError(ProcessFailure.ended(exitCode))
        .threadAlive(false);
  }

  @BeforeEach
  void killOnce() {
    monitor();
    live("a", 1.0);
    say(processEnded(137).instance("a"));
    kit.advance(0.3);
    assertThat(orders()).hasSize(1);
  }

  @Test
  void process_endsBeforeItReports_isAFailedAttemptAtOnce() {
    double beganS = kit.nowS();
    for (int attempt = 1; attempt <= 3; attempt++) {
      answer(orders().get(attempt - 1), true);
      kit.advance(0.1);
      say(processEnded(1));
      kit.advance(1.1);
    }

    assertThat(orders()).hasSize(3);
    assertThat(condition().action()).isEqualTo("failsafe, given up after 3 restarts");
    assertThat(kit.nowS() - beganS).as("no waiting for START WITHIN").isLessThan(5.0);
  }

  @Test
  void process_endsBeforeItsOrderIsAnswered_isAFailedAttempt() {
    say(processEnded(1));
    answer(orders().get(0), true);
    kit.advance(0.6);

    assertThat(orders()).hasSize(2);
  }

  @Test
  void process_rejectsItsInput_isGivenUpAtOnce() {
    answer(orders().get(0), true);
    kit.advance(0.1);
    say(processEnded(2));

    assertThat(condition().condition()).isEqualTo(Condition.LOST);
    assertThat(condition().reason()).isEqualTo("its process has ended with exit code 2");
    assertThat(condition().action()).isEqualTo("failsafe, given up: its process rejects its input");
    kit.advance(60.0);
    assertThat(orders()).hasSize(1);
  }

  @Test
  void process_startedAgainAfterItRejectedItsInput_isWatchedAsBefore() {
    answer(orders().get(0), true);
    say(processEnded(2));
    live("b", 1.0);
    assertThat(condition().condition()).isEqualTo(Condition.ALIVE);

    say(processEnded(137).instance("b"));
    kit.advance(1.0);

    assertThat(orders()).hasSize(2);
  }

  @Test
  void endOfTheReplacedProcess_whileTheNewOneStarts_isNoFailedStart() {
    answer(orders().get(0), true);
    say(processEnded(137).instance("a"));
    kit.advance(5.0);

    assertThat(orders()).hasSize(1);
  }

  @Test
  void start_failsForLackOfFiles_waitsLongerEachTimeAndUsesUpNoRestart() {
    double beganS = kit.nowS();
    int answered = 0;
    while (kit.nowS() - beganS < 10.0) {
      while (answered < orders().size()) {
        answer(orders().get(answered++), false, NO_FILES);
      }
      kit.advance(0.05);
    }
    assertThat(orders()).hasSize(7); // 0.5, 1, 2, 2, 2 and 2 s apart
    assertThat(condition().action()).startsWith("restart failed: ").contains("error=24");
    assertThat(condition().restarts()).isZero();

    kit.advance(2.0);
    assertThat(orders()).hasSize(8);
    answer(orders().get(7), true);
    live("b", 1.0);

    assertThat(condition().condition()).isEqualTo(Condition.ALIVE);
    assertThat(condition().restarts()).isEqualTo(1);
  }

  @Test
  void start_failsForLackOfFilesForLong_isGivenUp() {
    int answered = 0;
    for (double s = 0.0; s < 20.0; s += 0.05) {
      while (answered < orders().size()) {
        answer(orders().get(answered++), false, NO_FILES);
      }
      kit.advance(0.05);
    }

    assertThat(condition().action()).isEqualTo("failsafe, given up: no process can be started");
  }
}
