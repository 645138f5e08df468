package org.u2sa.trials.campaign;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.spark.RunBackendContract;

/** Processes of this machine. */
class WorkerPoolTest extends RunBackendContract {
  @Override
  protected RunBackend backend(Path directory) {
    return new WorkerPool(2, directory);
  }

  @Test
  void run_listenerThatThrowsWhileAnotherRunWaits_isToldNothingMore(@TempDir Path directory) {
    AtomicInteger told = new AtomicInteger();
    List<RunRequest> requests = List.of(request(1, false), request(2, false));

    assertThatThrownBy(
            () ->
                new WorkerPool(2, directory)
                    .run(
                        requests,
                        (request, answer) -> {
                          told.incrementAndGet();
                          awaitAnotherAtTheLock();
                          throw new AssertionError("enough");
                        }))
        .isInstanceOf(AssertionError.class)
        .hasMessage("enough");
    assertThat(told).hasValue(1);
  }

  private static void awaitAnotherAtTheLock() {
    ThreadGroup group = Thread.currentThread().getThreadGroup();
    while (Thread.getAllStackTraces().keySet().stream()
        .noneMatch(
            thread ->
                thread.getThreadGroup() == group
                    && thread.getName().startsWith("pool-")
                    && thread.getState() == Thread.State.BLOCKED)) {
      Thread.onSpinWait();
    }
  }

  @Test
  void inWords_anyNumber_isCounted() {
    assertThat(new WorkerPool(1, Path.of("x")).inWords()).isEqualTo("1 process");
    assertThat(new WorkerPool(3, Path.of("x")).inWords()).isEqualTo("3 processes");
  }
}
