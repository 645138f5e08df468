package org.u2sa.core.launch;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import org.u2sa.interfaces.XmlConfiguration;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.messages.MessageTypes;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.U2SAService;

/** Makes the services of one system: gives each its configuration, clock, transport and seed. */
final class ServiceMaker {
  private final String systemId;
  private final LaunchOptions options;
  private final MessageTypes types;
  private final Transport transport;

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
        path.map(XmlConfiguration::load)
            .orElseGet(() -> XmlConfiguration.inMemory(service, Map.of()));
    options.overridesOf(service).forEach(configuration::override);
    return configuration;
  }

  XmlConfiguration configuration(SystemFile.Entry entry) {
    return configuration(options, entry.simpleName(), entry.configuration());
  }

  ServiceContext context(XmlConfiguration configuration) {
    return ServiceContext.of(systemId, configuration)
        .clock(options.clock())
        .transport(transport)
        .logDirectory(options.logDirectory())
        .messageTypes(types)
        .seed(options.seed())
        .build();
  }

  /**
   * Makes a service that is connected and not yet started; should that fail, nothing is left of it.
   *
   * @throws org.u2sa.interfaces.BadInputException if its class or configuration is wrong
   * @throws org.u2sa.interfaces.communication.CommunicationException if it cannot connect
   */
  U2SAService make(SystemFile.Entry entry, XmlConfiguration configuration) {
    ServiceContext context = context(configuration);
    try {
      return ServiceFactory.create(entry, context);
    } catch (RuntimeException | Error e) {
      context.abandon(); // nobody else knows the half-made service
      throw e;
    }
  }
}
