package org.u2sa.interfaces.communication;

/** Transport to the Communication Manager: in-process or over MQTT, transparently for services. */
public interface Transport {
  /**
   * Connects a service, whose name is unique within the system.
   *
   * @throws CommunicationException if the Communication Manager is unreachable; names the address
   */
  Connection connect(String serviceName, Receiver receiver);

  /** System whose messages this transport carries: the second topic level. */
  String systemId();
}
