package org.u2sa.spark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.trials.campaign.RunAnswer;
import org.u2sa.trials.campaign.RunBackend;
import org.u2sa.trials.campaign.RunRequest;

/** What a campaign relies on, wherever its runs are made. The runs are {@link TrialCommand}s. */
@Timeout(600)
public abstract class RunBackendContract {
  private static final int RUNS = 12;

  @TempDir private Path directory;
  private final Map<Integer, RunAnswer> answers = new TreeMap<>();
  private RunBackend backend;

  /** What is judged, new for each test, with more than one core and less than a dozen. */
  protected abstract RunBackend backend(Path directory);

  @BeforeEach
  void begin() {
    backend = backend(directory);
  }

  protected static RunRequest request(int number, boolean keepsFiles, String... more) {
    List<String> arguments = new ArrayList<>(List.of("trial", "--seed", Integer.toString(number)));
    arguments.addAll(List.of(more));
    return new RunRequest(number, arguments, "run-" + number, keepsFiles);
  }

  private static List<RunRequest> requests() {
    return IntStream.rangeClosed(1, RUNS).mapToObj(number -> request(number, false)).toList();
  }

  private void take(RunRequest request, RunAnswer answer) {
    assertThat(answers.put(request.number(), answer)).as("run %d", request.number()).isNull();
  }

  private void assertAllMade(RunAnswer answer) {
    assertThat(answer).extracting(RunAnswer::exit, RunAnswer::errors).containsExactly(0, "");
  }

  @Test
  void run_requests_areEachAnsweredOnceWithWhatTheirRunSaid() throws InterruptedException {
    backend.run(requests(), this::take);

    assertThat(answers).hasSize(RUNS).allSatisfy((number, answer) -> assertAllMade(answer));
    assertThat(answers)
        .allSatisfy(
            (number, answer) ->
                assertThat(TrialCommand.seed(answer.output())).isEqualTo((long) number));
  }

  @Test
  void run_processesKilledOnTheWay_areReplaced() throws InterruptedException {
    Set<Long> seen = new HashSet<>();
    Set<Long> killed = new HashSet<>();
    backend.run(
        requests(),
        (request, answer) -> {
          take(request, answer);
          seen.add(TrialCommand.pid(answer.output()));
          if (answers.size() == 4) {
            seen.forEach(RunBackendContract::kill);
            killed.addAll(seen);
          }
        });

    assertThat(killed).isNotEmpty();
    assertThat(seen).hasSizeGreaterThan(killed.size());
    assertThat(answers).hasSize(RUNS).allSatisfy((number, answer) -> assertAllMade(answer));
  }

  private static void kill(long pid) {
    ProcessHandle.of(pid)
        .map(
            process -> {
              process.destroyForcibly();
              return process.onExit();
            })
        .ifPresent(CompletableFuture::join);
  }

  @Test
  void run_runThatKillsItsProcesses_isGivenUpAndTheOthersAreMade() throws InterruptedException {
    List<RunRequest> requests = new ArrayList<>(requests());
    requests.set(4, request(5, false, "--halt"));

    backend.run(requests, this::take);

    assertThat(answers).hasSize(RUNS);
    RunAnswer lost = answers.remove(5);
    assertThat(lost.exit()).isEqualTo(RunAnswer.LOST);
    assertThat(lost.errors()).contains("died");
    assertThat(answers).allSatisfy((number, answer) -> assertAllMade(answer));
  }

  @Test
  void run_exitCodeAndErrors_areTold() throws InterruptedException {
    backend.run(List.of(request(1, false, "--exit", "1"), request(2, false, "--what")), this::take);

    assertThat(answers.get(1).exit()).isEqualTo(ExitCode.FAILED);
    assertThat(answers.get(2).exit()).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(answers.get(2).errors()).contains("--what");
  }

  @Test
  void run_files_stayIfTheRunFailedOrKeepsThem() throws InterruptedException {
    backend.run(
        List.of(request(1, false), request(2, true), request(3, false, "--exit", "1")), this::take);

    assertThat(directory.resolve("run-1")).doesNotExist();
    assertThat(directory.resolve("run-2").resolve(TrialCommand.FILE)).hasContent("seed 2");
    assertThat(directory.resolve("run-3").resolve(TrialCommand.FILE)).hasContent("seed 3");
  }

  @Test
  void run_listenerThatThrows_endsItWithWhatWasThrown() {
    AtomicInteger told = new AtomicInteger();

    assertThatThrownBy(
            () ->
                backend.run(
                    requests(),
                    (request, answer) -> {
                      told.incrementAndGet();
                      throw new IllegalArgumentException("enough");
                    }))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("enough");
    assertThat(told).hasValue(1);
  }

  @Test
  void stop_onTheWay_tellsOfNoMoreRuns() throws InterruptedException {
    backend.run(
        requests(),
        (request, answer) -> {
          take(request, answer);
          if (answers.size() == 3) {
            backend.stop();
          }
        });

    assertThat(answers).hasSize(3);
  }

  @Test
  void run_stoppedBefore_makesNone() throws InterruptedException {
    backend.stop();

    backend.run(requests(), this::take);

    assertThat(answers).isEmpty();
  }

  @Test
  void run_noRequests_returns() throws InterruptedException {
    backend.run(List.of(), this::take);

    assertThat(answers).isEmpty();
  }
}
