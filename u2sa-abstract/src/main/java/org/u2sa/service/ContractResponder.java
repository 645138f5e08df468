package org.u2sa.service;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.ArrayList;
import java.util.List;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.FunctionalityRequest;
import org.u2sa.messages.contract.FunctionalityResponse;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.handover.SwapChoices;

/**
 * Answers the requests of the {@linkplain ServiceContract service contract} on the service's
 * thread.
 */
record ContractResponder(
    ServiceInstance service,
    ServiceLife life,
    ServiceConnection connection,
    ConfigurationResponder configuration) {

  void answer(U2SAData request) {
    if (request instanceof DiscoveryRequest) {
      connection.publish(Channels.DISCOVERY, discovery());
    } else if (request instanceof FunctionalityRequest) {
      connection.publish(Channels.FUNCTIONALITY, functionality());
    } else {
      configuration.answer(request);
    }
  }

  private DiscoveryResponse discovery() {
    DiscoveryResponse response =
        new DiscoveryResponse()
            .serviceName(service.getServiceName())
            .serviceType(service.role().name())
            .status(life.status())
            .host(host())
            .uptime(life.uptimeS())
            .version(version())
            .className(service.getClass().getName());
    connection.instance().ifPresent(response::instance);
    List<String> choices = SwapChoices.ofRole(service.role().name());
    if (!choices.isEmpty()) {
      response.choices(choices);
    }
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
        .publishes(described(connection.registrations().published()))
        .subscribes(described(connection.registrations().subscribed()));
  }

  private static List<String> described(List<Channel<?>> channels) {
    List<String> lines = new ArrayList<>();
    for (Channel<?> channel : channels) {
      lines.add(channel.name() + "/" + String.join("/", channel.type().chain()));
    }
    return lines;
  }
}
