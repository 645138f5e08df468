package org.u2sa.core.launch;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.u2sa.core.communication.CommunicationManager;
import org.u2sa.interfaces.XmlConfiguration;
import org.u2sa.messages.MessageTypes;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.U2SAService;

/** A system whose Communication Manager and services run in this process. */
public final class RunningSystem implements AutoCloseable {
  private static final String MANAGER = "CommunicationManager";

  private final SystemFile file;
  private final LaunchOptions options;
  private final MessageTypes types = MessageTypes.discovered();
  private final List<U2SAService> services = new ArrayList<>();
  private volatile CommunicationManager manager;

  private RunningSystem(SystemFile file, LaunchOptions options) {
    this.file = file;
    this.options = options;
  }

  /**
   * Starts the Communication Manager, makes all services, checks all that can be checked, and only
   * then starts the first thread. What cannot be started leaves nothing behind.
   *
   * @throws org.u2sa.interfaces.BadInputException if a file is wrong
   * @throws org.u2sa.interfaces.communication.CommunicationException if the Communication Manager
   *     cannot be started or reached
   */
  public static RunningSystem start(SystemFile file, LaunchOptions options) {
    RunningSystem system = new RunningSystem(file, options);
    try {
      system.prepare();
      system.services.forEach(U2SAService::start);
    } catch (RuntimeException | Error e) {
      system.closeAfter(e);
      throw e;
    }
    return system;
  }

  private void prepare() {
    file.services().forEach(ServiceFactory::constructor);
    XmlConfiguration communication = configuration(MANAGER, file.communication());
    manager = CommunicationManager.start(file.systemId(), communication, types, options.console());
    communication.refuseUndeclared();
    List<XmlConfiguration> configurations = new ArrayList<>();
    for (SystemFile.Entry entry : file.services()) {
      XmlConfiguration configuration = configuration(entry.simpleName(), entry.configuration());
      configurations.add(configuration);
      services.add(create(entry, context(configuration)));
    }
    configurations.forEach(XmlConfiguration::refuseUndeclared);
  }

  private static U2SAService create(SystemFile.Entry entry, ServiceContext context) {
    try {
      return ServiceFactory.create(entry, context);
    } catch (RuntimeException | Error e) {
      context.abandon(); // nobody else knows the half-made service
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

  private XmlConfiguration configuration(String service, Optional<Path> path) {
    XmlConfiguration configuration =
        path.map(XmlConfiguration::load)
            .orElseGet(() -> XmlConfiguration.inMemory(service, Map.of()));
    options.overridesOf(service).forEach(configuration::override);
    return configuration;
  }

  private ServiceContext context(XmlConfiguration configuration) {
    return ServiceContext.of(file.systemId(), configuration)
        .clock(options.clock())
        .transport(manager.transport())
        .logDirectory(options.logDirectory())
        .messageTypes(types)
        .seed(options.seed())
        .build();
  }

  /** The system's Communication Manager. */
  public CommunicationManager communicationManager() {
    return manager;
  }

  /** The services, in the order in which they were started. */
  public List<U2SAService> services() {
    return List.copyOf(services);
  }

  /**
   * The context that a further service of this system would get, for observers such as screens and
   * recorders.
   */
  public ServiceContext contextFor(XmlConfiguration configuration) {
    return context(configuration);
  }

  /** Whether any service still runs. */
  public boolean isRunning() {
    return services.stream().anyMatch(U2SAService::isRunning);
  }

  /** Waits until all services have ended, as after a stop command. */
  public void awaitEnd() throws InterruptedException {
    for (U2SAService service : services) {
      service.join();
    }
  }

  /** The services that ended because they failed. */
  public List<U2SAService> failed() {
    return services.stream()
        .filter(service -> service.status() == ServiceStatus.FAILED)
        .collect(Collectors.toList());
  }

  /**
   * Ends all services, last started first, and then the Communication Manager. Safe to call twice
   * and from several threads: each call returns when all has ended.
   */
  @Override
  public synchronized void close() {
    // Last started, first ended: control says its neutral commands while the services that carry
    // them out still run.
    for (int i = services.size() - 1; i >= 0; i--) {
      services.get(i).kill();
    }
    if (manager != null) {
      manager.close();
      manager = null;
    }
  }
}
