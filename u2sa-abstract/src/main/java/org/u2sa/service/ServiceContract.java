package org.u2sa.service;

import java.util.List;
import java.util.Optional;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.ConfigurationChange;
import org.u2sa.messages.contract.ConfigurationRequest;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.messages.contract.ConfigurationUndo;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.FunctionalityRequest;
import org.u2sa.messages.contract.ServiceMessage;
import org.u2sa.messages.safety.StopCommand;
import org.u2sa.messages.schema.U2SAData;

/** Decides which requests of the service contract (thesis 3.2.2.1) are addressed to a service. */
final class ServiceContract {
  /** Channels of requests to every service. */
  static final List<Channel<?>> CHANNELS =
      List.of(Channels.DISCOVERY, Channels.FUNCTIONALITY, Channels.STOP, Channels.CONFIGURATION);

  private ServiceContract() {}

  static boolean isOrderToStop(String serviceName, Channel<?> channel, U2SAData message) {
    return channel.equals(Channels.STOP)
        && message instanceof StopCommand stop
        && (stop.stopAll() || stop.serviceName().equals(Optional.of(serviceName)));
  }

  /** Whether the service answers the message. */
  static boolean concerns(String serviceName, Channel<?> channel, U2SAData message) {
    if (channel.equals(Channels.FUNCTIONALITY)) {
      return message instanceof FunctionalityRequest request
          && (request.serviceName().isEmpty() || request.serviceName().equals(serviceName));
    }
    return channel.equals(Channels.DISCOVERY)
        ? message instanceof DiscoveryRequest
        : channel.equals(Channels.CONFIGURATION) && isForConfigurationOf(serviceName, message);
  }

  private static boolean isForConfigurationOf(String serviceName, U2SAData message) {
    return message instanceof ConfigurationRequest all && all.serviceName().isEmpty()
        || (message instanceof ConfigurationRequest
                || message instanceof ConfigurationChange
                || message instanceof ConfigurationTransaction
                || message instanceof ConfigurationUndo)
            && message instanceof ServiceMessage<?> request
            && request.serviceName().equals(serviceName);
  }
}
