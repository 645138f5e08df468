package org.u2sa.spark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.trials.campaign.RunBackend;
import org.u2sa.trials.campaign.RunRequest;

/** Spark with a master and two workers. Needs SPARK_HOME. */
@Tag("spark")
class SparkClusterTest {
  private static final int RUNS = 12;

  @TempDir private Path directory;
  private StandaloneCluster cluster;

  @BeforeEach
  void begin() throws IOException {
    cluster = new StandaloneCluster(Files.createDirectory(directory.resolve("cluster")), 2);
  }

  @AfterEach
  void end() {
    cluster.close();
  }

  @Test
  void run_workerKilledInTheMiddle_makesEachRunOnce() throws IOException {
    Path meeting = Files.createDirectory(directory.resolve("meeting"));
    List<RunRequest> requests =
        IntStream.rangeClosed(1, RUNS)
            .mapToObj(number -> RunBackendContract.request(number, false, "--meet", meeting + ""))
            .toList();
    List<Long> seeds = new ArrayList<>();
    RunBackend backend = new SparkBackends().at(cluster.address(), directory);
    CompletableFuture<Void> end =
        CompletableFuture.runAsync(
            () -> {
              try {
                backend.run(
                    requests,
                    (request, answer) -> {
                      assertThat(answer.exit()).as(answer.errors()).isEqualTo(ExitCode.DONE);
                      seeds.add(TrialCommand.seed(answer.output()));
                    });
              } catch (InterruptedException e) {
                throw new CompletionException(e);
              }
            });
    await()
        .atMost(Duration.ofMinutes(3))
        .until(() -> end.isDone() || isMetFrom(0, meeting) && isMetFrom(1, meeting));
    assertThat(seeds).isEmpty(); // both workers are in the midst of their first run

    cluster.kill(1);
    Files.createFile(meeting.resolve(TrialCommand.GO_ON));
    end.join();

    assertThat(seeds)
        .containsExactlyInAnyOrderElementsOf(
            IntStream.rangeClosed(1, RUNS).mapToObj(seed -> (long) seed).toList());
  }

  private boolean isMetFrom(int worker, Path meeting) throws IOException {
    try (Stream<Path> pids = Files.list(meeting)) {
      return pids.map(pid -> Long.parseLong(pid.getFileName().toString())).toList().stream()
          .anyMatch(pid -> cluster.isOf(worker, pid));
    }
  }
}
