package org.u2sa.scenarios.cessna;

import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.util.HashSet;
import java.util.Set;

/** The threads of this virtual machine, to see whether something was left half-started. */
final class RunningThreads {
  private static final Duration ENDED_WITHIN = Duration.ofSeconds(60);

  private RunningThreads() {}

  static Set<Thread> now() {
    return new HashSet<>(Thread.getAllStackTraces().keySet());
  }

  /** Fails if a thread that did not run before still runs after some seconds. */
  static void requireNoneSince(Set<Thread> before) {
    await()
        .pollInSameThread()
        .atMost(ENDED_WITHIN)
        .untilAsserted(
            () -> {
              Set<Thread> added = now();
              added.removeAll(before);
              added.removeIf(each -> each.getName().equals("u2sa-disk")); // one for the process
              if (!added.isEmpty()) {
                throw new AssertionError("still running: " + added);
              }
            });
  }
}
