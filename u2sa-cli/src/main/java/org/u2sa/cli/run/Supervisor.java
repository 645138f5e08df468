package org.u2sa.cli.run;

import java.io.IOException;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import org.u2sa.core.launch.Launcher;
import org.u2sa.core.launch.ProcessFailure;
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
import org.u2sa.service.U2SAService;

/**
 * Executes start and restart orders when each service has its own process: ends it, by SIGKILL if
 * it hangs, and starts it again. Until then, actuators go neutral as their commands expire.
 *
 * <p>It reports ended processes on the health channel. It restarts a health monitor's process
 * without an order, because nobody else would order it, and any process while no monitor works.
 */
final class Supervisor implements ServiceHost, AutoCloseable {
  private static final long SPOKE_WITHIN_MICROS = 1_000_000; // reports arrive four times a second

  private final SystemFile file;
  private final RunningSystem system;
  private final ServiceProcesses processes;
  private final ServiceNames names;
  private final Launcher launcher;
  private final Clock clock = new SystemClock();
  private final MonitorGuard guard;
  private final Map<String, String> replaced = new ConcurrentHashMap<>(); // instances by entry

  /** Connects and starts executing orders; {@code system} is the Communication Manager. */
  Supervisor(
      SystemFile file,
      KnownNames known,
      RunningSystem system,
      ServiceProcesses processes,
      Consumer<String> console) {
    this.file = file;
    this.system = system;
    this.processes = processes;
    names =
        new ServiceNames(
            file,
            known,
            system.communicationManager()::isOwn,
            system.communicationManager().transport(),
            clock,
            console);
    ServiceContext context = system.contextFor(XmlConfiguration.inMemory(Launcher.NAME, Map.of()));
    try {
      launcher = new Launcher(context, Launcher.NAME, this);
      launcher.start();
    } catch (RuntimeException | Error e) {
      context.abandon();
      names.close();
      throw e;
    }
    guard = new MonitorGuard(names, clock, new GuardedProcesses(console), console);
    guard.start();
    processes.onFailure(this::ended);
    Thread end = new Thread(this::endWithAll, "u2sa-end-of-system");
    end.setDaemon(true);
    end.start();
  }

  /** Waits until all services are ordered to stop, and ends those that were still starting. */
  private void endWithAll() {
    try {
      launcher.awaitEnd();
      if (launcher.endReason().filter(U2SAService.ALL_STOPPED::equals).isPresent()) {
        processes.endAll();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /**
   * Acts if no monitor does, and reports the end immediately, because this process detects it
   * first, and the broker only sees a broken link.
   */
  private void ended(String entry, int exitCode) {
    Optional<ServiceNames.Word> last = names.nameOf(entry).flatMap(names::lastWord);
    guard.ended(entry, exitCode);
    names
        .nameOf(entry)
        .ifPresent(
            name -> {
              ConnectionLost word = new ConnectionLost();
              word.serviceName(name)
                  .status(ServiceStatus.FAILED)
                  .lastError(ProcessFailure.ended(exitCode))
                  .threadAlive(false);
              // From the missing instance, a monitor infers that this start has failed.
              last.map(ServiceNames.Word::instance)
                  .filter(instance -> !instance.equals(replaced.get(entry)))
                  .ifPresent(word::instance);
              launcher.publish(Channels.HEALTH, word);
            });
  }

  private final class GuardedProcesses implements MonitorGuard.Processes {
    private final Consumer<String> console;

    GuardedProcesses(Consumer<String> console) {
      this.console = console;
    }

    @Override
    public boolean isAlive(String entry) {
      return processes.isAlive(entry);
    }

    @Override
    public void startProcess(String entry) {
      Supervisor.this.startProcess(entry).ifPresent(console);
    }
  }

  @Override
  public boolean isFor(ServiceOrder order) {
    return order.action() != ServiceAction.SWAP && names.entryOf(order.serviceName()).isPresent();
  }

  @Override
  public Optional<String> start(String serviceName) {
    String entry = names.entryOf(serviceName).orElseThrow();
    return processes.isAlive(entry)
        ? Optional.of("service " + serviceName + " is already running")
        : startProcess(entry);
  }

  @Override
  public Optional<String> restart(String serviceName) {
    return startProcess(names.entryOf(serviceName).orElseThrow());
  }

  @Override
  public Optional<String> swap(String serviceName, String className) {
    return Optional.of("a service must be swapped in its own process");
  }

  private Optional<String> startProcess(String entry) {
    boolean speaks = speaks(entry);
    Optional<String> refusal = speaks ? refusal(entry) : Optional.empty();
    if (refusal.isPresent()) {
      return refusal; // the running process is kept
    }
    try {
      names
          .nameOf(entry)
          .flatMap(names::lastWord)
          .ifPresent(said -> replaced.put(entry, said.instance()));
      return processes.startProcess(entry, speaks)
          ? Optional.empty()
          : Optional.of("the system is ending");
    } catch (IOException e) {
      return Optional.of(ProcessFailure.notStarted(e));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return Optional.of("interrupted");
    }
  }

  private Optional<String> refusal(String entry) {
    return file.services().stream()
        .filter(each -> each.simpleName().equals(entry))
        .findFirst()
        .flatMap(system::refusalToRestart);
  }

  private boolean speaks(String entry) {
    long sinceMicros = clock.micros() - SPOKE_WITHIN_MICROS;
    return names
        .nameOf(entry)
        .flatMap(names::lastWord)
        .filter(word -> word.atMicros() > sinceMicros)
        .isPresent();
  }

  @Override
  public void close() {
    guard.close();
    launcher.kill();
    names.close();
  }
}
