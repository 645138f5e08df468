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
import org.u2sa.interfaces.Clock;
import org.u2sa.interfaces.SystemClock;
import org.u2sa.interfaces.XmlConfiguration;
import org.u2sa.messages.contract.ServiceAction;
import org.u2sa.messages.contract.ServiceOrder;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/**
 * Carries orders to start and restart out where each service has a process of its own: kills it
 * (SIGKILL: it may hang) and starts it again. Actuators go neutral meanwhile as their commands
 * expire.
 *
 * <p>A health monitor's process that ended badly is started again without an order, as nobody else
 * would give one.
 */
final class Supervisor implements ServiceHost, AutoCloseable {
  private static final long MONITOR_AT_MOST_EVERY_MICROS = 1_000_000;

  private final ServiceProcesses processes;
  private final ServiceNames names;
  private final Launcher launcher;
  private final Consumer<String> console;
  private final Clock clock = new SystemClock();
  private final Map<String, Long> monitorStarts = new ConcurrentHashMap<>();

  /**
   * Connects and begins to obey.
   *
   * @param system the Communication Manager of the processes
   */
  Supervisor(
      SystemFile file, RunningSystem system, ServiceProcesses processes, Consumer<String> console) {
    this.processes = processes;
    this.console = console;
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
    processes.onFailure(this::restartMonitor);
  }

  private void restartMonitor(String entry) {
    if (!names.roleOf(entry).equals(Optional.of(ServiceRole.HEALTH_MONITOR.name()))) {
      return;
    }
    long now = clock.micros();
    Long before = monitorStarts.put(entry, now);
    if (before != null && now - before < MONITOR_AT_MOST_EVERY_MICROS) {
      console.accept("Service " + entry + " ends at once each time: it is given up.");
      return;
    }
    startAnew(entry).ifPresent(console);
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
    launcher.kill();
    names.close();
  }
}
