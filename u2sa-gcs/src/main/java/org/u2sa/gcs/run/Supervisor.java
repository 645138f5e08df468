package org.u2sa.gcs.run;

import java.io.IOException;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import org.u2sa.core.launch.Launcher;
import org.u2sa.core.launch.RunningSystem;
import org.u2sa.core.launch.ServiceHost;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.contract.ConnectionLost;
import org.u2sa.messages.contract.ServiceAction;
import org.u2sa.messages.contract.ServiceOrder;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/**
 * Carries orders to start and restart out where each service has a process of its own: kills it
 * (SIGKILL: it may hang) and starts it again. Actuators go neutral meanwhile as their commands
 * expire.
 *
 * <p>It says of a process that ended so, on health. A health monitor's process it starts again
 * without an order, as nobody else would give one.
 */
final class Supervisor implements ServiceHost, AutoCloseable {
  private final ServiceProcesses processes;
  private final ServiceNames names;
  private final Launcher launcher;
  private final Clock clock = new SystemClock();
  private final MonitorGuard guard;

  /**
   * Connects and begins to obey.
   *
   * @param system the Communication Manager of the processes
   */
  Supervisor(
      SystemFile file, RunningSystem system, ServiceProcesses processes, Consumer<String> console) {
    this.processes = processes;
    names = new ServiceNames(file, system.communicationManager().transport(), clock, console);
    ServiceContext context = system.contextFor(XmlConfiguration.inMemory(Launcher.NAME, Map.of()));
    try {
      launcher = new Launcher(context, Launcher.NAME, this);
      launcher.start();
    } catch (RuntimeException | Error e) {
      context.abandon();
      names.close();
      throw e;
    }
    guard =
        new MonitorGuard(
            names, Launcher.NAME, clock, entry -> startAnew(entry).ifPresent(console), console);
    processes.onFailure(this::ended);
  }

  /** Says so at once, as nobody knows it sooner; the broker learns only that a link broke. */
  private void ended(String entry, int exitCode) {
    names
        .nameOf(entry)
        .ifPresent(
            name -> {
              ConnectionLost word = new ConnectionLost();
              word.serviceName(name)
                  .status(ServiceStatus.FAILED)
                  .lastError("its process has ended with exit code " + exitCode)
                  .threadAlive(false);
              names.lastWord(name).ifPresent(last -> word.instance(last.instance()));
              launcher.publish(Channels.HEALTH, word);
            });
    guard.ended(entry);
  }

  @Override
  public boolean isFor(ServiceOrder order) {
    return order.action() != ServiceAction.SWAP && names.entryOf(order.serviceName()).isPresent();
  }

  @Override
  public Optional<String> start(String serviceName) {
    String entry = names.entryOf(serviceName).orElseThrow();
    return processes.isAlive(entry)
        ? Optional.of("service " + serviceName + " runs already")
        : startAnew(entry);
  }

  @Override
  public Optional<String> restart(String serviceName) {
    return startAnew(names.entryOf(serviceName).orElseThrow());
  }

  @Override
  public Optional<String> swap(String serviceName, String className) {
    return Optional.of("a service is swapped in its own process");
  }

  private Optional<String> startAnew(String entry) {
    try {
      return processes.startAnew(entry) ? Optional.empty() : Optional.of("the system is ending");
    } catch (IOException e) {
      return Optional.of("the process cannot be started: " + e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return Optional.of("interrupted");
    }
  }

  @Override
  public void close() {
    guard.close();
    launcher.kill();
    names.close();
  }

  /**
   * Supervises the health monitor: starts a health monitor's process again when it has ended badly,
   * and kills it when it has been silent for long, as nobody else would order that. One thread. A
   * silence in which the own launcher is not heard either is a broken link, and nobody's fault.
   */
  private static final class MonitorGuard implements AutoCloseable {
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
}
