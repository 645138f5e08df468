package org.u2sa.drivers.ioio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.util.List;
import java.util.Set;

/** Tells which threads of the IOIO library and of ours there are. */
final class LibraryThreads {
  private LibraryThreads() {}

  /** Those that run now. */
  static List<String> names() {
    Set<Thread> all = Thread.getAllStackTraces().keySet();
    return all.stream()
        .filter(Thread::isAlive)
        .filter(
            thread ->
                thread.getClass().getName().startsWith("ioio.")
                    || thread.getName().startsWith("u2sa-ioio"))
        .map(thread -> thread.getName() + " (" + thread.getClass().getSimpleName() + ")")
        .toList();
  }

  /** Waits until none runs. */
  static void awaitNone() {
    await("the end of all threads")
        .atMost(Duration.ofSeconds(20))
        .untilAsserted(() -> assertThat(names()).isEmpty());
  }
}
