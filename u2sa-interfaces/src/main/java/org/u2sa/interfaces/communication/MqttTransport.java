package org.u2sa.interfaces.communication;

import java.util.Objects;
import java.util.Random;
import org.eclipse.paho.client.mqttv3.MqttConnectOptions;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.schema.MessageCodec;

/**
 * The way to a Communication Manager in another process, or to any other MQTT broker.
 *
 * @param host the broker's name or address
 * @param port the broker's TCP port, 1…65535
 * @param systemId the system whose messages are exchanged; {@link Topic#ANY_SYSTEM} hears those of
 *     all systems on the broker and publishes none
 * @param codec what writes and reads messages
 * @param access how each client logs in
 * @param patienceS how long the first attempt to connect may last [s]
 * @param client what speaks MQTT
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
  /** A dead link is found within twice this time here, and within 1.5 times it by the broker. */
  private static final int KEEP_ALIVE_S = 2;

  private static final int CONNECT_WITHIN_S = 3;

  /**
   * @throws IllegalArgumentException if the port or the system ID is none
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

  /** A transport for a broker that wants neither user nor encryption. */
  public MqttTransport(String host, int port, String systemId, MessageCodec codec) {
    this(host, port, systemId, codec, BrokerAccess.open());
  }

  /** A transport that connects each service with a client of its own, at once. */
  public MqttTransport(
      String host, int port, String systemId, MessageCodec codec, BrokerAccess access) {
    this(host, port, systemId, codec, access, 0.0, MqttClient.ofProcess());
  }

  /**
   * The same transport, whose first attempt to connect may last: so that a host may be started
   * before the one with the broker.
   *
   * @param seconds how long to try to reach a broker that is not there yet [s], at least 0
   */
  public MqttTransport waiting(double seconds) {
    return new MqttTransport(host, port, systemId, codec, access, seconds, client);
  }

  /**
   * The same transport by another client.
   *
   * @param other what speaks MQTT, whatever the process has been told
   */
  public MqttTransport by(MqttClient other) {
    return new MqttTransport(host, port, systemId, codec, access, patienceS, other);
  }

  /**
   * The way to another system on the same broker, for who wants to hear it: its vehicles otherwise
   * do not notice each other.
   *
   * @param otherSystemId the system, or {@link Topic#ANY_SYSTEM} to hear all
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
    // Paho would try MQTT 3.1 after a refusal, and then tell of that attempt's failure only.
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
