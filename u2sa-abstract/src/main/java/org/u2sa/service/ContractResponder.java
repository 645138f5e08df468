package org.u2sa.service;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.FunctionalityRequest;
import org.u2sa.messages.contract.FunctionalityResponse;
import org.u2sa.messages.safety.StopCommand;
import org.u2sa.messages.schema.U2SAData;

/**
 * Answers the requests of the service contract (thesis 3.2.2.1): discovery, functionality discovery
 * and, by its {@link ConfigurationResponder}, configuration. Runs on the service's thread; the stop
 * command is recognised here but executed by the service.
 */
final class ContractResponder {
  /** Channels of requests to every service. */
  static final List<Channel<?>> CHANNELS =
      List.of(Channels.DISCOVERY, Channels.FUNCTIONALITY, Channels.STOP, Channels.CONFIGURATION);

  private final U2SAService service;
  private final ConfigurationResponder configuration;
  private final ServiceWiring wiring;

  ContractResponder(U2SAService service) {
    this.service = service;
    configuration = new ConfigurationResponder(service);
    wiring = service.wiring;
  }

  /** Whether the message orders this service to stop. */
  boolean isOrderToStop(Channel<?> channel, U2SAData message) {
    return channel.equals(Channels.STOP)
        && message instanceof StopCommand stop
        && (stop.stopAll() || stop.serviceName().equals(Optional.of(service.getServiceName())));
  }

  /** Whether the message is a request that {@link #answer} would answer. */
  boolean concerns(Channel<?> channel, U2SAData message) {
    if (channel.equals(Channels.FUNCTIONALITY)) {
      return message instanceof FunctionalityRequest request && isForThis(request.serviceName());
    }
    return channel.equals(Channels.DISCOVERY)
        ? message instanceof DiscoveryRequest
        : channel.equals(Channels.CONFIGURATION) && configuration.concerns(message);
  }

  private boolean isForThis(String serviceName) {
    return serviceName.isEmpty() || serviceName.equals(service.getServiceName());
  }

  /** Answers a request that concerns this service. */
  void answer(U2SAData request) {
    if (request instanceof DiscoveryRequest) {
      service.publish(Channels.DISCOVERY, discovery());
    } else if (request instanceof FunctionalityRequest) {
      service.publish(Channels.FUNCTIONALITY, functionality());
    } else {
      configuration.answer(request);
    }
  }

  /** Writer of configuration changes, off the service's thread. */
  ConfigurationWriter configurationWriter() {
    return configuration.writer();
  }

  private DiscoveryResponse discovery() {
    DiscoveryResponse response =
        new DiscoveryResponse()
            .serviceName(service.getServiceName())
            .serviceType(service.role().name())
            .status(service.status())
            .host(host())
            .uptime(service.life.uptimeS())
            .version(version())
            .className(service.getClass().getName());
    wiring.instance().ifPresent(response::instance);
    return response;
  }

  private static String host() {
    try {
      return InetAddress.getLocalHost().getHostName();
    } catch (UnknownHostException e) {
      return "localhost"; // the host name does not resolve
    }
  }

  private String version() {
    String version = service.getClass().getPackage().getImplementationVersion();
    return version == null ? "unversioned" : version;
  }

  private FunctionalityResponse functionality() {
    return new FunctionalityResponse()
        .serviceName(service.getServiceName())
        .publishes(described(wiring.registrations().published()))
        .subscribes(described(wiring.registrations().subscribed()));
  }

  private static List<String> described(List<Channel<?>> channels) {
    List<String> lines = new ArrayList<>();
    for (Channel<?> channel : channels) {
      lines.add(channel.name() + "/" + String.join("/", channel.type().chain()));
    }
    return lines;
  }
}
