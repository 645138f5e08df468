package org.u2sa.interfaces.mqtt;

import java.util.Objects;
import java.util.Random;
import org.eclipse.paho.client.mqttv3.MqttConnectOptions;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.schema.MessageCodec;

/**
 * Transport to a Communication Manager in another process, or to any other MQTT broker.
 *
 * @param host the broker's name or address
 * @param port the broker's TCP port, 1…65535
 * @param systemId system whose messages are exchanged; {@link Topic#ANY_SYSTEM} receives from all
 *     systems on the broker and publishes only messages that name their system
 * @param codec message codec
 * @param access credentials
 * @param patienceS time limit of the first connection [s]
 * @param client MQTT client implementation
 */
public record MqttTransport(
    String host,
    int port,
    String systemId,
    MessageCodec codec,
    BrokerAccess access,
    double patienceS,
    MqttClient client)
    implements Transport {
  /**
   * Keep-alive. A dead link is detected within twice this time here and within 1.5 times by the
   * broker.
   */
  private static final int KEEP_ALIVE_S = 2;

  private static final int CONNECT_WITHIN_S = 3;

  /**
   * @throws IllegalArgumentException if the port or system ID is invalid
   */
  public MqttTransport {
    if (port < 1 || port > 65_535) {
      throw new IllegalArgumentException("port: " + port + " is outside 1…65535");
    }
    Objects.requireNonNull(host, "host");
    Objects.requireNonNull(codec, "codec");
    Objects.requireNonNull(access, "access");
    Objects.requireNonNull(client, "client");
    if (!systemId.equals(Topic.ANY_SYSTEM)) {
      Topic.checkSystemId(systemId);
    }
  }

  /** Creates a transport for a broker without login or encryption. */
  public MqttTransport(String host, int port, String systemId, MessageCodec codec) {
    this(host, port, systemId, codec, BrokerAccess.open());
  }

  /** Creates a transport with one client per service. */
  public MqttTransport(
      String host, int port, String systemId, MessageCodec codec, BrokerAccess access) {
    this(host, port, systemId, codec, access, 0.0, MqttClient.ofProcess());
  }

  /**
   * Copy with a time limit for the first connection, so that a host can be started before the
   * broker's.
   *
   * @param seconds time to wait for an absent broker [s], at least 0
   */
  public MqttTransport waiting(double seconds) {
    return new MqttTransport(host, port, systemId, codec, access, seconds, client);
  }

  /**
   * Copy with another client implementation.
   *
   * @param other client implementation, overriding the process default
   */
  public MqttTransport by(MqttClient other) {
    return new MqttTransport(host, port, systemId, codec, access, patienceS, other);
  }

  /**
   * Transport to another system on the same broker, whose systems are otherwise isolated from each
   * other.
   *
   * @param otherSystemId the system, or {@link Topic#ANY_SYSTEM} to receive from all
   */
  public MqttTransport ofSystem(String otherSystemId) {
    return new MqttTransport(host, port, otherSystemId, codec, access, patienceS, client);
  }

  @Override
  public Connection connect(String serviceName, Receiver receiver) {
    MqttConnection connection =
        new MqttConnection(
            access.scheme() + "://" + host + ":" + port,
            systemId,
            serviceName,
            codec,
            receiver,
            client);
    connection.open(this::options, patienceS, new SystemClock(), new Random());
    return connection;
  }

  private MqttConnectOptions options() {
    MqttConnectOptions options = new MqttConnectOptions();
    options.setCleanSession(true);
    // Otherwise Paho retries with MQTT 3.1 after a rejection and reports only that failure.
    options.setMqttVersion(MqttConnectOptions.MQTT_VERSION_3_1_1);
    options.setKeepAliveInterval(KEEP_ALIVE_S);
    options.setConnectionTimeout(CONNECT_WITHIN_S);
    options.setSocketFactory(access.sockets());
    if (access.user().isPresent()) {
      options.setUserName(access.user().get());
      options.setPassword(access.password());
    } else if (!access.isEncrypted()) {
      LocalToken.read(host, port)
          .ifPresent(
              token -> {
                options.setUserName(LocalToken.USER);
                options.setPassword(token);
              });
    }
    return options;
  }
}
