package org.u2sa.core.launch;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.service.Execution;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.U2SAService;

/** Makes the services of one system: gives each its configuration, clock, transport and seed. */
final class ServiceMaker {
  private final String systemId;
  private final LaunchOptions options;
  private final MessageTypes types;
  private final Transport transport;
  private volatile Execution.Keeper keeper; // null if nobody keeps executions

  ServiceMaker(String systemId, LaunchOptions options, MessageTypes types, Transport transport) {
    this.systemId = systemId;
    this.options = options;
    this.types = types;
    this.transport = transport;
  }

  /** Reads a configuration file, or takes the variables' defaults, with the run's overrides. */
  static XmlConfiguration configuration(
      LaunchOptions options, String service, Optional<Path> path) {
    XmlConfiguration configuration =
        path.map(options::load).orElseGet(() -> XmlConfiguration.inMemory(service, Map.of()));
    options.overridesOf(service).forEach(configuration::override);
    return configuration;
  }

  XmlConfiguration configuration(SystemFile.Entry entry) {
    return configuration(options, entry.simpleName(), entry.configuration());
  }

  ServiceContext context(XmlConfiguration configuration) {
    return builder(configuration).build();
  }

  private ServiceContext.Builder builder(XmlConfiguration configuration) {
    return ServiceContext.of(systemId, configuration)
        .clock(options.clock())
        .transport(transport)
        .logDirectory(options.logDirectory())
        .messageTypes(types)
        .seed(options.seed())
        .restart(options.restart());
  }

  /**
   * Makes a service that is connected and not yet started; should that fail, nothing is left of it.
   *
   * @throws org.u2sa.interfaces.BadInputException if its class or configuration is wrong
   * @throws org.u2sa.interfaces.communication.CommunicationException if it cannot connect
   */
  U2SAService make(SystemFile.Entry entry, XmlConfiguration configuration) {
    return make(kept(entry.className(), context(configuration)), made(entry));
  }

  /**
   * Makes a service that stands in no system file.
   *
   * @throws RuntimeException if its constructor refuses
   */
  U2SAService make(LaunchOptions.Companion companion) {
    return make(context(companion.configuration()), companion.maker());
  }

  /**
   * Makes a service anew that ran before in this run, of a class that may stand in no system file.
   *
   * @throws RuntimeException if the class is no service or its constructor refuses
   */
  U2SAService makeAnew(String className, XmlConfiguration configuration) {
    ServiceContext context = builder(configuration).restart(true).build();
    return make(kept(className, context), made(className));
  }

  /**
   * Makes a service that is to take the place of one that runs; it is not connected.
   *
   * @throws RuntimeException if the class is no service or its constructor refuses
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
   * The context of a service whose execution is kept, if somebody keeps any. That of a service with
   * a device of its own could not be repeated.
   */
  private ServiceContext kept(String className, ServiceContext context) {
    Execution.Keeper present = keeper;
    return present == null || options.makerOf(className).isPresent()
        ? context
        : present.keep(className, context).map(context::with).orElse(context);
  }

  private U2SAService make(
      ServiceContext context, Function<ServiceContext, ? extends U2SAService> constructor) {
    try {
      U2SAService service = constructor.apply(context);
      context.execution().ifPresent(execution -> execution.made(service));
      if (service instanceof Execution.Keeper) {
        keeper = (Execution.Keeper) service;
      }
      return service;
    } catch (RuntimeException | Error e) {
      context.abandon(); // nobody else knows the half-made service
      throw e;
    }
  }
}
