package org.u2sa.interfaces.communication;

import java.util.Objects;
import org.u2sa.messages.MessageCodec;

/**
 * The way to a Communication Manager in another process, or to any other MQTT broker, with Eclipse
 * Paho.
 */
public final class MqttTransport implements Transport {
  private final String host;
  private final int port;
  private final String systemId;
  private final MessageCodec codec;
  private final BrokerAccess access;

  /**
   * A transport that connects each service with a client of its own.
   *
   * @param host the broker's name or address
   * @param port the broker's TCP port, 1…65535
   * @param systemId the system whose messages are exchanged; {@link Topic#ANY_SYSTEM} hears those
   *     of all systems on the broker and publishes none
   * @param codec what reads incoming messages
   */
  public MqttTransport(String host, int port, String systemId, MessageCodec codec) {
    this(host, port, systemId, codec, BrokerAccess.open());
  }

  /**
   * A transport for a broker that wants a user or encryption.
   *
   * @param access as whom and how each client comes; the rest as above
   */
  public MqttTransport(
      String host, int port, String systemId, MessageCodec codec, BrokerAccess access) {
    if (port < 1 || port > 65_535) {
      throw new IllegalArgumentException("port: " + port + " is outside 1…65535");
    }
    this.host = Objects.requireNonNull(host, "host");
    this.port = port;
    this.systemId = systemId.equals(Topic.ANY_SYSTEM) ? systemId : Topic.checkSystemId(systemId);
    this.codec = Objects.requireNonNull(codec, "codec");
    this.access = Objects.requireNonNull(access, "access");
  }

  @Override
  public Connection connect(String serviceName, Receiver receiver) {
    MqttConnection connection =
        new MqttConnection(
            access.scheme() + "://" + host + ":" + port, systemId, serviceName, codec, receiver);
    connection.open(access);
    return connection;
  }

  @Override
  public String systemId() {
    return systemId;
  }
}
