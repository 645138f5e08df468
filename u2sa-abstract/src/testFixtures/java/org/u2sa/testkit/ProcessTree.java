package org.u2sa.testkit;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.stream.Stream;

/**
 * The end of a program beside the tests' own virtual machine, with all programs that it started.
 *
 * <p>Both methods return once none of them runs: a program that is still writing would make the
 * deletion of a test's folder fail, and one that still listens would keep its port.
 */
public final class ProcessTree {
  private static final Duration PATIENCE = Duration.ofSeconds(20);

  private ProcessTree() {}

  /** Kills it (SIGKILL). */
  public static void kill(Process process) {
    killAndAwait(all(process));
  }

  /** Asks it to end (SIGTERM) and kills what still runs 20 s later. */
  public static void end(Process process) {
    List<ProcessHandle> all = all(process);
    process.destroy();
    try {
      ends(all).get(PATIENCE.toMillis(), TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      killAndAwait(all);
    } catch (ExecutionException | TimeoutException e) {
      killAndAwait(all);
    }
  }

  private static List<ProcessHandle> all(Process process) {
    return Stream.concat(process.toHandle().descendants(), Stream.of(process.toHandle())).toList();
  }

  private static void killAndAwait(List<ProcessHandle> all) {
    all.forEach(ProcessHandle::destroyForcibly);
    ends(all).orTimeout(PATIENCE.toMillis(), TimeUnit.MILLISECONDS).join();
  }

  private static CompletableFuture<Void> ends(List<ProcessHandle> all) {
    return CompletableFuture.allOf(
        all.stream().map(ProcessHandle::onExit).toArray(CompletableFuture<?>[]::new));
  }
}
