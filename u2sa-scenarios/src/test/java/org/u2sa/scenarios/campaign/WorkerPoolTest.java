package org.u2sa.scenarios.campaign;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.gcs.command.ExitCode;
import org.u2sa.interfaces.BadInputException;

/** With processes of this Java, whose runs only print the version. */
@Timeout(300)
class WorkerPoolTest {
  private static final List<String> FAST = List.of("--version");
  private static final List<Experiment> RUNS = Experiment.all(FAST, 1, 12, List.of());

  @TempDir private Path directory;
  private final List<Outcome> outcomes = new ArrayList<>();
  private final AtomicReference<WorkerPool> pool = new AtomicReference<>();

  private void begin(int jobs, Function<Experiment, List<String>> command) {
    pool.set(new WorkerPool(jobs, directory.resolve("workers.log"), command));
  }

  private void killAll() {
    CompletableFuture<?>[] ends =
        pool.get().pids().stream()
            .flatMap(pid -> ProcessHandle.of(pid).stream())
            .map(
                process -> {
                  process.destroyForcibly();
                  return process.onExit();
                })
            .toArray(CompletableFuture<?>[]::new);
    CompletableFuture.allOf(ends).join();
  }

  @Test
  void run_twoProcesses_makeEachRunOnce() throws InterruptedException {
    begin(2, experiment -> FAST);

    pool.get().run(RUNS, outcomes::add);

    assertThat(outcomes).extracting(Outcome::experiment).containsExactlyInAnyOrderElementsOf(RUNS);
    assertThat(outcomes).allMatch(Outcome::success);
    assertThat(pool.get().pids()).isEmpty();
  }

  @Test
  void run_processesKilledOnTheWay_areReplaced() throws InterruptedException {
    begin(2, experiment -> FAST);

    pool.get()
        .run(
            RUNS,
            outcome -> {
              outcomes.add(outcome);
              if (outcomes.size() % 5 == 0) {
                killAll();
              }
            });

    assertThat(outcomes).extracting(Outcome::experiment).containsExactlyInAnyOrderElementsOf(RUNS);
    assertThat(outcomes).allMatch(Outcome::success);
  }

  @Test
  void run_runThatKillsItsProcesses_isGivenUpAndTheOthersAreMade() throws InterruptedException {
    begin(
        1,
        experiment -> {
          if (experiment.number() == 2) {
            killAll();
          }
          return FAST;
        });

    pool.get().run(RUNS, outcomes::add);

    assertThat(outcomes).extracting(outcome -> outcome.experiment().number()).hasSize(12);
    assertThat(outcomes)
        .filteredOn(outcome -> !outcome.success())
        .singleElement()
        .satisfies(
            outcome -> {
              assertThat(outcome.experiment().number()).isEqualTo(2);
              assertThat(outcome.exit()).isEqualTo(Outcome.LOST);
              assertThat(outcome.trouble()).contains("has died");
            });
  }

  @Test
  void run_optionThatIsRefused_endsTheCampaignWithWhatWasWrong() {
    begin(1, experiment -> List.of("demo", "ugv", "--loopz"));

    assertThatThrownBy(() -> pool.get().run(RUNS, outcomes::add))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("--loopz");
    assertThat(outcomes).isEmpty();
  }

  @Test
  void stop_onTheWay_beginsNoMoreRuns() throws InterruptedException {
    begin(1, experiment -> FAST);

    pool.get()
        .run(
            RUNS,
            outcome -> {
              outcomes.add(outcome);
              if (outcomes.size() == 3) {
                pool.get().stop();
              }
            });

    assertThat(outcomes).hasSize(3).allMatch(outcome -> outcome.exit() == ExitCode.DONE);
  }
}
