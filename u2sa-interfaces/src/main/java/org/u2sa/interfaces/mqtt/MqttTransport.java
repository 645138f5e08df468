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
 * @param port TCP port, 1…65535
 * @param systemId system whose messages are exchanged; {@link Topic#ANY_SYSTEM} receives from all
 *     systems on the broker and publishes only messages that name their system
 * @param patienceS time limit of the first connection [s]
 * @param isService whether the broker reports a lost connection as the failure of a service, as its
 *     last will
 */
public record MqttTransport(
    String host,
    int port,
    String systemId,
    MessageCodec codec,
    BrokerAccess access,
    double patienceS,
    MqttClient client,
    boolean isService)
    implements Transport {
  /** A dead link is detected within twice this time here, within 1.5 times by the broker. */
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

  /** Without login or encryption. */
  public MqttTransport(String host, int port, String systemId, MessageCodec codec) {
    this(host, port, systemId, codec, BrokerAccess.open());
  }

  /** Creates a transport with one client per service. */
  public MqttTransport(
      String host, int port, String systemId, MessageCodec codec, BrokerAccess access) {
    this(host, port, systemId, codec, access, 0.0, MqttClient.ofProcess(), true);
  }

  /**
   * Copy that waits for an absent broker at the first connection.
   *
   * @param seconds time limit [s], at least 0
   */
  public MqttTransport waiting(double seconds) {
    return new MqttTransport(host, port, systemId, codec, access, seconds, client, isService);
  }

  /** Copy with another client implementation than the process default. */
  public MqttTransport by(MqttClient other) {
    return new MqttTransport(host, port, systemId, codec, access, patienceS, other, isService);
  }

  /** Copy with a different log-in; an empty name is anonymous. */
  public MqttTransport as(String user, char[] password) {
    return new MqttTransport(
        host, port, systemId, codec, access.as(user, password), patienceS, client, isService);
  }

  /** Copy for another system on the same broker, or {@link Topic#ANY_SYSTEM}. */
  public MqttTransport ofSystem(String otherSystemId) {
    return new MqttTransport(
        host, port, otherSystemId, codec, access, patienceS, client, isService);
  }

  /** Copy for a program that joins a system without being one of its services. */
  public MqttTransport ofTool() {
    return new MqttTransport(host, port, systemId, codec, access, patienceS, client, false);
  }

  @Override
  public Connection connect(String serviceName, Receiver receiver) {
    MqttConnection connection =
        new MqttConnection(
            access.at(host, port).scheme() + "://" + host + ":" + port,
            systemId,
            serviceName,
            codec,
            receiver,
            client,
            isService);
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
    BrokerAccess now = access.at(host, port); // a broker that was started again has another
    options.setSocketFactory(now.sockets());
    if (now.user().isPresent()) {
      options.setUserName(now.user().get());
      options.setPassword(now.password());
    } else if (now.usesToken()) {
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
