package org.u2sa.core.launch;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Collectors;
import org.u2sa.core.communication.CommunicationManager;
import org.u2sa.core.communication.ManagerVariables;
import org.u2sa.core.communication.PortTakenException;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.U2SAService;

/**
 * A system whose Communication Manager and services run in this process, with the {@link Launcher}
 * that starts and restarts them on order.
 */
public final class RunningSystem implements AutoCloseable {
  private static final String MANAGER = "CommunicationManager";

  private final SystemFile file;
  private final LaunchOptions options;
  private final MessageTypes types = MessageTypes.discovered();
  private final List<U2SAService> companions = new ArrayList<>(); // ended last
  private volatile CommunicationManager manager;
  private volatile ServiceMaker maker;
  private volatile HostedServices hosted;
  private volatile Launcher launcher; // null if no services are started
  private volatile HealthWatch watch; // likewise

  private RunningSystem(SystemFile file, LaunchOptions options) {
    this.file = file;
    this.options = options;
  }

  /**
   * Starts the Communication Manager, creates all services, performs all checks, and only then
   * starts the first thread. A failed start leaves nothing behind.
   *
   * @throws org.u2sa.interfaces.BadInputException if a file is wrong
   * @throws org.u2sa.interfaces.communication.CommunicationException if the Communication Manager
   *     cannot be started or reached
   */
  public static RunningSystem start(SystemFile file, LaunchOptions options) {
    RunningSystem system = new RunningSystem(file, options);
    try {
      system.prepare();
      system.companions.forEach(U2SAService::start);
      system.services().forEach(U2SAService::start);
      if (system.launcher != null) {
        system.launcher.start();
        system.startWatch();
      }
    } catch (RuntimeException | Error e) {
      system.closeAfter(e);
      throw e;
    }
    return system;
  }

  private void prepare() {
    requireFolder(options.logDirectory);
    file.services().stream()
        .filter(entry -> options.makerOf(entry.className()).isEmpty())
        .forEach(ServiceFactory::constructor);
    XmlConfiguration communication = options.configuration(MANAGER, file.communication());
    setPort(communication, ManagerVariables.WEB_PORT, file.webPort());
    setPort(communication, ManagerVariables.ROSBRIDGE_PORT, file.rosbridgePort());
    manager = startManager(communication);
    communication.refuseUndeclared();
    maker = new ServiceMaker(file.systemId(), options, types, transport());
    options.companions.forEach(companion -> companions.add(maker.make(companion)));
    hosted = new HostedServices(maker, options.supervised, options.console);
    hosted.makeAll(file.services());
    if (!options.oneOfSeveral && !manager.isExternal()) { // otherwise others may fill the gaps
      ChannelGaps.of(hosted.services())
          .forEach(gap -> options.console.accept(file.file() + ": " + gap));
    }
    if (!file.services().isEmpty()) {
      launcher = makeLauncher();
    }
  }

  /** Sets a port as in the system file, unless the run's options set it. */
  private void setPort(XmlConfiguration communication, String variable, OptionalInt port) {
    if (port.isPresent() && !options.isOverridden(MANAGER, variable)) {
      communication.override(variable, port.getAsInt());
    }
  }

  /**
   * Starts the Communication Manager. The attempt to listen decides whether a port is taken: after
   * a test in advance, another program could still take it.
   */
  private CommunicationManager startManager(XmlConfiguration communication) {
    try {
      return CommunicationManager.start(file.systemId(), communication, types, options.console);
    } catch (PortTakenException e) {
      if (options.otherPort.isEmpty()) {
        throw e;
      }
      int port = freePort(e);
      communication.override(ManagerVariables.PORT, port);
      CommunicationManager started =
          CommunicationManager.start(file.systemId(), communication, types, options.console);
      options.otherPort.get().accept(port);
      return started;
    }
  }

  private static int freePort(PortTakenException cause) {
    try (ServerSocket free = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      return free.getLocalPort();
    } catch (IOException e) {
      cause.addSuppressed(e);
      throw cause;
    }
  }

  /**
   * Checks that the path is not a file: an unwritable folder may become writable later, but a file
   * never becomes a folder.
   */
  private static void requireFolder(Path logs) {
    if (Files.exists(logs) && !Files.isDirectory(logs)) {
      throw new BadInputException(logs + ": is not a folder, expected one for log files");
    }
  }

  /** Transport to the Communication Manager; checks names first if another process runs it. */
  private Transport transport() {
    Transport transport = throughBroker() ? brokerTransport() : manager.transport();
    if (!manager.isExternal() || file.services().isEmpty()) {
      return transport; // no other process can run yet
    }
    if (options.besideManager) {
      return transport; // anyone could answer a discovery request
    }
    Clock clock = options.clock;
    boolean real = clock instanceof SystemClock;
    Clock stopwatch = real ? clock : new SystemClock();
    DuplicateCheck duplicates =
        options.restart
            ? DuplicateCheck.forTime(transport, stopwatch, options.console)
            : DuplicateCheck.before(transport, stopwatch, options.console);
    if (real) {
      options.clock(((SystemClock) clock).ahead(duplicates.systemAheadMicros()));
    }
    return duplicates;
  }

  private boolean throughBroker() {
    return options.throughBroker || file.delivery() == Delivery.BROKER;
  }

  private Transport brokerTransport() {
    if (options.clock instanceof LockstepClock) { // which cannot wait for messages in transit
      throw new BadInputException(
          file.file() + ": messages through the broker take real time; expected --realtime");
    }
    return manager
        .brokerTransport()
        .orElseThrow(
            () ->
                new BadInputException(
                    file.file()
                        + ": messages are to go through the broker, but variable \"BROKER\" of "
                        + MANAGER
                        + " is none; expected embedded or external"));
  }

  private void startWatch() {
    watch = new HealthWatch(options.clock, this::services, launcher);
    watch.start();
  }

  private Launcher makeLauncher() {
    String name =
        options.oneOfSeveral
            ? Launcher.NAME + "-" + services().get(0).getServiceName()
            : Launcher.NAME;
    ServiceContext context = contextFor(XmlConfiguration.inMemory(name, Map.of()));
    try {
      return new Launcher(context, name, hosted);
    } catch (RuntimeException | Error e) {
      context.abandon();
      throw e;
    }
  }

  private void closeAfter(Throwable failure) {
    try {
      close();
    } catch (RuntimeException e) {
      failure.addSuppressed(e);
    }
  }

  /** The system's Communication Manager. */
  public CommunicationManager communicationManager() {
    return manager;
  }

  /**
   * Snapshot of the system file's services, in file order, including restarted and swapped ones.
   */
  public List<U2SAService> services() {
    return hosted == null ? List.of() : hosted.services();
  }

  /** The context for an additional service of this system, such as a screen or a recorder. */
  public ServiceContext contextFor(XmlConfiguration configuration) {
    return maker.context(configuration);
  }

  /**
   * Reason why a service in another process could not be restarted; empty if a check without
   * opening its devices finds none.
   */
  public Optional<String> refusalToRestart(SystemFile.Entry entry) {
    try {
      maker.tryOut(entry.className(), maker.configuration(entry));
      return Optional.empty();
    } catch (RuntimeException | LinkageError e) {
      return Optional.of(String.valueOf(e.getMessage()));
    }
  }

  /** Whether any service still runs. */
  public boolean isRunning() {
    return services().stream().anyMatch(U2SAService::isRunning);
  }

  /**
   * Waits until all services have ended, including restarted ones, for example after a stop
   * command.
   */
  public void awaitEnd() throws InterruptedException {
    List<U2SAService> awaited;
    do {
      awaited = services();
      for (U2SAService service : awaited) {
        service.awaitEnd();
      }
    } while (!awaited.equals(services()));
  }

  /** The services that ended because they failed. */
  public List<U2SAService> failed() {
    return services().stream()
        .filter(service -> service.status() == ServiceStatus.FAILED)
        .collect(Collectors.toList());
  }

  /**
   * Ends all services, last started first, and then the Communication Manager. Idempotent and
   * thread-safe: each call returns when everything has ended.
   */
  @Override
  public synchronized void close() {
    if (watch != null) {
      watch.close();
    }
    if (launcher != null) {
      launcher.kill(); // first, so that nothing starts during shutdown
    }
    if (hosted != null) {
      hosted.close();
    }
    companions.forEach(U2SAService::shutDown);
    if (manager != null) {
      manager.close();
      manager = null;
    }
  }
}
