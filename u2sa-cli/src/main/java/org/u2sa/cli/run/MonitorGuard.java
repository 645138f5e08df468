package org.u2sa.cli.run;

import java.util.ArrayDeque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.core.launch.Launcher;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;

/**
 * Supervises the health monitor, and restarts ended processes in its place while no monitor works.
 *
 * <p>It restarts a health monitor's process that failed or has been silent for too long, a limited
 * number of times, because nothing else would. If reports of this process's own launcher do not
 * arrive either, the silence is attributed to a broken link. Processes of other services are left
 * to the monitor's policy while a monitor reports. Without a monitor, because the system has none
 * or it has also ended, the guard restarts the process immediately, a limited number of times.
 *
 * <p>One thread checks for silence; ends may be reported from any thread.
 */
final class MonitorGuard implements AutoCloseable {
  private static final long LOOKS_EVERY_MICROS = 500_000;
  private static final long SILENT_AFTER_MICROS = 4_000_000; // same as a monitor's LOST AFTER
  private static final long STARTS_WITHIN_MICROS = 15_000_000;
  private static final long DEAF_AFTER_MICROS = 1_000_000;
  private static final long AT_MOST_EVERY_MICROS = 1_000_000;
  private static final int MAX_RESTARTS = 3; // RESTART LIMIT and window of a monitor
  private static final long RESTART_WINDOW_MICROS = 60_000_000;

  interface Processes {
    boolean isAlive(String entry);

    void startProcess(String entry);
  }

  private final ServiceNames names;
  private final Clock clock;
  private final Processes processes;
  private final Consumer<String> console;
  private final Map<String, Long> starts = new HashMap<>(); // monitors only; guarded by this
  private final Map<String, Long> ends = new LinkedHashMap<>(); // unhandled; guarded by this
  private final Map<String, ArrayDeque<Long>> restarts = new HashMap<>(); // guarded by this
  private final Set<String> givenUp = new HashSet<>(); // silent monitors; guarded by this
  private final Thread thread = new Thread(this::watch, "u2sa-monitor-guard");
  private Clock.Waiter waiter; // null until started
  private long excusedMicros; // silence is excused until then; own thread only
  private long failures; // own thread only
  private volatile boolean closed;

  MonitorGuard(ServiceNames names, Clock clock, Processes processes, Consumer<String> console) {
    this.names = names;
    this.clock = clock;
    this.processes = processes;
    this.console = console;
    thread.setDaemon(true);
  }

  void start() {
    waiter = clock.newWaiter(thread.getName());
    thread.start();
  }

  private void watch() {
    try {
      while (!closed) {
        waiter.await(clock.micros() + LOOKS_EVERY_MICROS);
        if (!closed) {
          tryToLook();
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      waiter.close();
    }
  }

  private void tryToLook() {
    try {
      look(clock.micros());
    } catch (RuntimeException | OutOfMemoryError e) {
      if (Long.bitCount(++failures) == 1) { // log at 1, 2, 4, 8…: checks run at 2 Hz
        console.accept(LogLevelEnum.ERROR + ": supervising the health monitor failed: " + e);
      }
    }
  }

  synchronized void look(long now) {
    if (silentMicros(Launcher.NAME, now) > DEAF_AFTER_MICROS) {
      excusedMicros = now;
    }
    for (String entry : names.monitors()) {
      Optional<ServiceNames.Word> word = wordOf(entry);
      if (word.isEmpty() || word.get().isLast() || isGivenUp(entry, word.get())) {
        continue;
      }
      if (isGone(entry, word.get(), now)) {
        console.accept("Service " + entry + " is silent.");
        restartMonitor(entry, now);
      }
    }
    ends.values().removeIf(ended -> now - ended > SILENT_AFTER_MICROS);
  }

  private Optional<ServiceNames.Word> wordOf(String entry) {
    return names.nameOf(entry).flatMap(names::lastWord);
  }

  /** Whether the monitor was declared failed and has not reported since. */
  private boolean isGivenUp(String entry, ServiceNames.Word word) {
    if (word.atMicros() > starts.getOrDefault(entry, Long.MIN_VALUE)) {
      givenUp.remove(entry);
    }
    return givenUp.contains(entry);
  }

  private boolean isGone(String entry, ServiceNames.Word word, long now) {
    long started = starts.getOrDefault(entry, Long.MIN_VALUE);
    long since = Math.max(Math.max(word.atMicros(), started), excusedMicros);
    return now - since > (word.atMicros() > started ? SILENT_AFTER_MICROS : STARTS_WITHIN_MICROS);
  }

  private long silentMicros(String serviceName, long now) {
    return names.lastWord(serviceName).map(word -> now - word.atMicros()).orElse(0L);
  }

  synchronized void ended(String entry, int exitCode) {
    long now = clock.micros();
    boolean isMonitor = names.monitors().contains(entry);
    if (isMonitor && (exitCode != ExitCode.BAD_INPUT || wordOf(entry).isPresent())) {
      Long before = starts.get(entry);
      if (before != null && now - before < AT_MOST_EVERY_MICROS) {
        console.accept("Service " + entry + " repeatedly ends immediately; giving up.");
        starts.put(entry, now);
      } else {
        restartMonitor(entry, now);
      }
    } else if (exitCode != ExitCode.BAD_INPUT) { // bad input would be rejected again
      ends.put(entry, now);
      restartUnlessMonitored(now);
    }
  }

  private void restartMonitor(String entry, long now) {
    starts.put(entry, now);
    if (!restart(entry, now)) {
      givenUp.add(entry);
    }
    restartUnlessMonitored(now); // not handled by a monitor
  }

  private void restartUnlessMonitored(long now) {
    if (names.monitors().stream().anyMatch(this::speaks)) {
      return;
    }
    for (String entry : ends.keySet()) {
      if (!processes.isAlive(entry)) {
        restart(entry, now);
      }
    }
    ends.clear();
  }

  /** Whether a monitor's process is alive and has reported since its start. */
  private boolean speaks(String entry) {
    long started = starts.getOrDefault(entry, Long.MIN_VALUE);
    return processes.isAlive(entry)
        && wordOf(entry).filter(word -> !word.isLast() && word.atMicros() > started).isPresent();
  }

  /** Returns whether it was restarted; if not, it was restarted too often. */
  private boolean restart(String entry, long now) {
    ArrayDeque<Long> before = restarts.computeIfAbsent(entry, key -> new ArrayDeque<>());
    before.removeIf(at -> now - at > RESTART_WINDOW_MICROS);
    if (before.size() >= MAX_RESTARTS) {
      String what = names.monitors().contains(entry) ? " keeps failing" : " keeps ending";
      console.accept("Service " + entry + what + "; giving up after three restarts.");
      return false;
    }
    before.add(now);
    processes.startProcess(entry);
    return true;
  }

  @Override
  public void close() {
    closed = true;
    waiter.close();
    try {
      thread.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
