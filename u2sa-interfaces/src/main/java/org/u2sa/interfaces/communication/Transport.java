package org.u2sa.interfaces.communication;

/**
 * A way to the Communication Manager: directly within its own process, or over MQTT. Services
 * cannot tell which.
 */
public interface Transport {
  /**
   * Connects one service.
   *
   * @param serviceName the service's name; unique within the system
   * @param receiver called with each message of the channels that the connection subscribes to
   * @throws CommunicationException if the Communication Manager cannot be reached; names the
   *     address
   */
  Connection connect(String serviceName, Receiver receiver);

  /** The system whose messages this transport carries: the second level of its topics. */
  String systemId();
}
