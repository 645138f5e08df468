package org.u2sa.gcs.run;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.service.ServiceRole;

/**
 * Supervises the health monitor: starts a health monitor's process again when it has ended badly,
 * and kills it when it has been silent for long, as nobody else would order that. One thread. A
 * silence in which the own launcher is not heard either is a broken link, and nobody's fault.
 */
final class MonitorGuard implements AutoCloseable {
  private static final long LOOKS_EVERY_MICROS = 500_000;
  private static final long SILENT_AFTER_MICROS = 4_000_000; // as a monitor's LOST AFTER
  private static final long STARTS_WITHIN_MICROS = 15_000_000;
  private static final long DEAF_AFTER_MICROS = 1_000_000;
  private static final long AT_MOST_EVERY_MICROS = 1_000_000;

  private final ServiceNames names;
  private final String ownName;
  private final Clock clock;
  private final Consumer<String> startAnew;
  private final Consumer<String> console;
  private final Map<String, Long> starts = new ConcurrentHashMap<>(); // by entry
  private final Clock.Waiter waiter;
  private final Thread thread = new Thread(this::watch, "u2sa-monitor-guard");
  private long excusedMicros; // until when silences are not counted; touched by the thread only
  private volatile boolean closed;

  /**
   * @param ownName under which the launcher of this process reports
   * @param startAnew starts the entry's process again
   * @param console takes what it has to say, a line each
   */
  MonitorGuard(
      ServiceNames names,
      String ownName,
      Clock clock,
      Consumer<String> startAnew,
      Consumer<String> console) {
    this.names = names;
    this.ownName = ownName;
    this.clock = clock;
    this.startAnew = startAnew;
    this.console = console;
    waiter = clock.newWaiter(thread.getName());
    thread.setDaemon(true);
    thread.start();
  }

  private void watch() {
    try {
      while (!closed) {
        waiter.await(clock.micros() + LOOKS_EVERY_MICROS);
        if (!closed) {
          look(clock.micros());
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      waiter.close();
    }
  }

  private void look(long now) {
    if (silentMicros(ownName, now) > DEAF_AFTER_MICROS) {
      excusedMicros = now;
    }
    for (String entry : names.entriesOf(ServiceRole.HEALTH_MONITOR.name())) {
      Optional<ServiceNames.Word> word = names.nameOf(entry).flatMap(names::lastWord);
      if (word.isPresent() && !word.get().isLast() && isGone(entry, word.get(), now)) {
        console.accept("Service " + entry + " is silent.");
        starts.put(entry, now);
        startAnew.accept(entry);
      }
    }
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
  void ended(String entry) {
    if (!names.roleOf(entry).equals(Optional.of(ServiceRole.HEALTH_MONITOR.name()))) {
      return;
    }
    long now = clock.micros();
    Long before = starts.put(entry, now);
    if (before != null && now - before < AT_MOST_EVERY_MICROS) {
      console.accept("Service " + entry + " keeps ending at once; giving up.");
      return;
    }
    startAnew.accept(entry);
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
