package org.u2sa.gcs.run;

import java.util.ArrayDeque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.u2sa.core.launch.Launcher;
import org.u2sa.gcs.command.ExitCode;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.service.ServiceRole;

/**
 * Supervises the health monitor, and restarts in its place what ends while no monitor works.
 *
 * <p>It restarts a health monitor's process when it has ended badly, and when it has been silent
 * for long, as nobody else would order that. A silence in which the own launcher is not heard
 * either is a broken link, and nobody's fault. The process of any other service is the monitor's
 * concern by its policy, as long as a monitor speaks. While none does, because the system has none,
 * or because it ended too, the guard restarts the process at once, a few times.
 *
 * <p>One thread looks for silence; ends are told by any.
 */
final class MonitorGuard implements AutoCloseable {
  private static final long LOOKS_EVERY_MICROS = 500_000;
  private static final long SILENT_AFTER_MICROS = 4_000_000; // as a monitor's LOST AFTER
  private static final long STARTS_WITHIN_MICROS = 15_000_000;
  private static final long DEAF_AFTER_MICROS = 1_000_000;
  private static final long AT_MOST_EVERY_MICROS = 1_000_000;
  private static final int MAX_RESTARTS = 3; // as a monitor's RESTART LIMIT, as the window is
  private static final long RESTART_WINDOW_MICROS = 60_000_000;

  /** The processes of the services, by entry. */
  interface Processes {
    boolean isAlive(String entry);

    /** Starts the entry's process again. */
    void startAnew(String entry);
  }

  private final ServiceNames names;
  private final Clock clock;
  private final Processes processes;
  private final Consumer<String> console;
  private final Map<String, Long> starts = new HashMap<>(); // of monitors; guarded by this
  private final Map<String, Long> ends = new LinkedHashMap<>(); // not dealt with; guarded by this
  private final Map<String, ArrayDeque<Long>> restarts = new HashMap<>(); // guarded by this
  private final Thread thread = new Thread(this::watch, "u2sa-monitor-guard");
  private Clock.Waiter waiter; // null until started
  private long excusedMicros; // until when silences are not counted; touched by the thread only
  private long failures; // likewise
  private volatile boolean closed;

  /**
   * @param console takes what it has to say, a line each
   */
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
    } catch (RuntimeException e) {
      if (Long.bitCount(++failures) == 1) { // 1, 2, 4, 8…: it looks twice a second
        console.accept(LogLevelEnum.ERROR + ": supervising the health monitor failed: " + e);
      }
    }
  }

  /** Looks for monitors that are silent. */
  synchronized void look(long now) {
    if (silentMicros(Launcher.NAME, now) > DEAF_AFTER_MICROS) {
      excusedMicros = now;
    }
    for (String entry : names.entriesOf(ServiceRole.HEALTH_MONITOR.name())) {
      Optional<ServiceNames.Word> word = wordOf(entry);
      if (word.isPresent() && !word.get().isLast() && isGone(entry, word.get(), now)) {
        console.accept("Service " + entry + " is silent.");
        restartMonitor(entry, now);
      }
    }
    ends.values().removeIf(ended -> now - ended > SILENT_AFTER_MICROS);
  }

  private Optional<ServiceNames.Word> wordOf(String entry) {
    return names.nameOf(entry).flatMap(names::lastWord);
  }

  private boolean isGone(String entry, ServiceNames.Word word, long now) {
    long started = starts.getOrDefault(entry, Long.MIN_VALUE);
    long since = Math.max(Math.max(word.atMicros(), started), excusedMicros);
    return now - since > (word.atMicros() > started ? SILENT_AFTER_MICROS : STARTS_WITHIN_MICROS);
  }

  private long silentMicros(String serviceName, long now) {
    return names.lastWord(serviceName).map(word -> now - word.atMicros()).orElse(0L);
  }

  /** Takes note that an entry's process has ended badly. */
  synchronized void ended(String entry, int exitCode) {
    long now = clock.micros();
    if (isMonitor(entry)) {
      Long before = starts.get(entry);
      if (before != null && now - before < AT_MOST_EVERY_MICROS) {
        console.accept("Service " + entry + " keeps ending at once; giving up.");
        starts.put(entry, now);
      } else {
        restartMonitor(entry, now);
      }
    } else if (exitCode != ExitCode.BAD_INPUT) { // which would be refused again
      ends.put(entry, now);
      restartUnlessMonitored(now);
    }
  }

  private boolean isMonitor(String entry) {
    return names.roleOf(entry).equals(Optional.of(ServiceRole.HEALTH_MONITOR.name()));
  }

  private void restartMonitor(String entry, long now) {
    starts.put(entry, now);
    processes.startAnew(entry);
    restartUnlessMonitored(now); // what the monitor has not seen to
  }

  private void restartUnlessMonitored(long now) {
    if (names.entriesOf(ServiceRole.HEALTH_MONITOR.name()).stream().anyMatch(this::speaks)) {
      return;
    }
    for (String entry : ends.keySet()) {
      if (!processes.isAlive(entry)) {
        restart(entry, now);
      }
    }
    ends.clear();
  }

  /** Whether a monitor's process lives and has been heard since it was started. */
  private boolean speaks(String entry) {
    long started = starts.getOrDefault(entry, Long.MIN_VALUE);
    return processes.isAlive(entry)
        && wordOf(entry).filter(word -> !word.isLast() && word.atMicros() > started).isPresent();
  }

  private void restart(String entry, long now) {
    ArrayDeque<Long> before = restarts.computeIfAbsent(entry, key -> new ArrayDeque<>());
    before.removeIf(at -> now - at > RESTART_WINDOW_MICROS);
    if (before.size() >= MAX_RESTARTS) {
      console.accept("Service " + entry + " keeps ending; giving up after three restarts.");
      return;
    }
    before.add(now);
    processes.startAnew(entry);
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
