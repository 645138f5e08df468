package org.u2sa.core.launch;

import java.io.IOException;
import java.util.function.Function;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.U2SAService;
import org.u2sa.service.handover.RememberedStates;

/** Creates the services of one system, each with its configuration, clock, transport and seed. */
final class ServiceMaker {
  private final String systemId;
  private final LaunchOptions options;
  private final MessageTypes types;
  private final Transport transport;
  private final RememberedStates remembered = new RememberedStates();
  private volatile ServiceContext.ExecutionKeeper keeper; // null if executions are not recorded

  ServiceMaker(String systemId, LaunchOptions options, MessageTypes types, Transport transport) {
    this.systemId = systemId;
    this.options = options;
    this.types = types;
    this.transport = transport;
  }

  XmlConfiguration configuration(SystemFile.Entry entry) {
    return options.configuration(entry);
  }

  ServiceContext context(XmlConfiguration configuration) {
    return builder(configuration).build();
  }

  private ServiceContext.Builder builder(XmlConfiguration configuration) {
    return ServiceContext.of(systemId, configuration)
        .clock(options.clock)
        .transport(transport)
        .logDirectory(options.logDirectory)
        .messageTypes(types)
        .seed(options.seed)
        .restart(options.restart)
        .devices(options.devices)
        .remembered(remembered);
  }

  /**
   * Creates and connects a service without starting it; cleans up if that fails.
   *
   * @throws org.u2sa.interfaces.BadInputException if its class or configuration is wrong
   * @throws org.u2sa.interfaces.communication.CommunicationException if it cannot connect
   */
  U2SAService make(SystemFile.Entry entry, XmlConfiguration configuration) {
    return make(kept(entry.className(), context(configuration)), made(entry));
  }

  /** Creates a service that is not in the system file; throws what its constructor throws. */
  U2SAService make(LaunchOptions.Companion companion) {
    return make(context(companion.configuration()), companion.maker());
  }

  /**
   * Recreates a service that already ran in this run, of a class that need not be in the system
   * file.
   *
   * @throws RuntimeException if the class is not a service or its constructor throws
   */
  U2SAService makeAnew(String className, XmlConfiguration configuration) {
    ServiceContext context = builder(configuration).restart(true).build();
    return make(kept(className, context), made(className));
  }

  /**
   * Constructs a trial instance of a service and discards it, before the running instance is ended:
   * if the constructor fails, e.g. because of a file named by a variable, the running one must go
   * on. The trial instance is neither connected nor started, and construction stops where it would
   * open a device. Does nothing for a class with its own factory, which may hold devices of the
   * host.
   *
   * @param configuration read for this trial
   * @throws RuntimeException what its constructor threw
   */
  void tryOut(String className, XmlConfiguration configuration) {
    if (options.makerOf(className).isPresent()) {
      return;
    }
    try (TemporaryFolder logs = TemporaryFolder.create("u2sa-trial")) {
      ServiceContext context =
          builder(configuration)
              .transport(new LocalBus(systemId))
              .logDirectory(logs.path())
              .restart(true)
              .trial(true)
              .build();
      tryOut(className, context);
    } catch (IOException e) { // a full disk must not prevent a restart
      options.console.accept("Restart without a trial: " + e);
    }
  }

  private static void tryOut(String className, ServiceContext context) {
    try {
      ServiceFactory.create(className, context).shutDown();
      context.configuration().refuseUndeclared();
    } catch (ServiceContext.TrialEnded e) {
      return; // the configuration was accepted up to its device
    } finally {
      context.abandon();
    }
  }

  /**
   * Creates a replacement for a running service, without connecting it.
   *
   * @throws RuntimeException if the class is not a service or its constructor throws
   */
  U2SAService makeInPlaceOf(U2SAService running, String className, XmlConfiguration configuration) {
    ServiceContext context = builder(configuration).inPlaceOf(running).build();
    return make(kept(className, context), made(className));
  }

  private Function<ServiceContext, ? extends U2SAService> made(SystemFile.Entry entry) {
    return options
        .makerOf(entry.className())
        .orElse(context -> ServiceFactory.create(entry, context));
  }

  private Function<ServiceContext, ? extends U2SAService> made(String className) {
    return options.makerOf(className).orElse(context -> ServiceFactory.create(className, context));
  }

  /**
   * Context of a service, recording its execution if executions are recorded. Services with their
   * own devices are excluded, because they cannot be replayed.
   */
  private ServiceContext kept(String className, ServiceContext context) {
    ServiceContext.ExecutionKeeper present = keeper;
    return present == null || options.makerOf(className).isPresent()
        ? context
        : present.keep(className, context).map(context::with).orElse(context);
  }

  private U2SAService make(
      ServiceContext context, Function<ServiceContext, ? extends U2SAService> constructor) {
    try {
      U2SAService service = constructor.apply(context);
      context.execution().made(service);
      if (service instanceof ServiceContext.ExecutionKeeper) {
        keeper = (ServiceContext.ExecutionKeeper) service;
      }
      return service;
    } catch (RuntimeException | Error e) {
      context.abandon(); // nothing else references the partial service
      throw e;
    }
  }
}
