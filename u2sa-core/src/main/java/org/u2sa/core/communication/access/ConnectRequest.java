package org.u2sa.core.communication.access;

import io.netty.handler.codec.mqtt.MqttConnectMessage;
import io.netty.handler.codec.mqtt.MqttConnectPayload;
import io.netty.handler.codec.mqtt.MqttConnectReturnCode;
import io.netty.handler.codec.mqtt.MqttConnectVariableHeader;
import io.netty.handler.codec.mqtt.MqttVersion;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.UUID;
import org.u2sa.core.communication.limit.BrokerLimits;

/** The contents of a client's first packet. */
public final class ConnectRequest {
  /** Reason for refusing a request, with the return code for the client (MQTT 3.1.1, 3.2.2.3). */
  public enum Fault {
    VERSION(
        "its version of MQTT is neither 3.1 nor 3.1.1",
        MqttConnectReturnCode.CONNECTION_REFUSED_UNACCEPTABLE_PROTOCOL_VERSION),
    LONG_ID(
        "its client ID is too long", MqttConnectReturnCode.CONNECTION_REFUSED_IDENTIFIER_REJECTED),
    NO_ID(
        "it has no client ID but requests a persistent session", // 3.1.3.1
        MqttConnectReturnCode.CONNECTION_REFUSED_IDENTIFIER_REJECTED),
    WILL("its will has QoS 2", MqttConnectReturnCode.CONNECTION_REFUSED_NOT_AUTHORIZED);

    private final String reason;
    private final MqttConnectReturnCode answer;

    Fault(String reason, MqttConnectReturnCode answer) {
      this.reason = reason;
      this.answer = answer;
    }

    /** Why the request is refused, for the log. */
    public String reason() {
      return reason;
    }

    /** Return code of the CONNACK. */
    public MqttConnectReturnCode answer() {
      return answer;
    }
  }

  /**
   * The client's will, published when its connection breaks.
   *
   * @param eachMatters whether QoS 1 is requested
   */
  public record Will(String topic, byte[] payload, boolean eachMatters, boolean isRetained) {}

  private final MqttConnectMessage packet;
  private final String clientId;
  private final boolean isNamed; // by the client
  private final String pass;

  private ConnectRequest(MqttConnectMessage packet, String clientId, boolean isNamed, String pass) {
    this.packet = packet;
    this.clientId = clientId;
    this.isNamed = isNamed;
    this.pass = pass;
  }

  /**
   * @param pass secret with which the connection filter replaces an admitted client's password
   */
  public static ConnectRequest of(MqttConnectMessage packet, String pass) {
    String said = packet.payload().clientIdentifier();
    // mosquitto_sub and HiveMQ's client let the broker assign a name by default
    boolean isNamed = said != null && !said.isEmpty();
    String id = isNamed ? said : "unnamed-" + UUID.randomUUID();
    return new ConnectRequest(packet, id, isNamed, pass);
  }

  /** Reason for refusing it regardless of the user, or empty. */
  public Optional<Fault> fault() {
    int version = packet.variableHeader().version();
    if (version != MqttVersion.MQTT_3_1_1.protocolLevel()
        && version != MqttVersion.MQTT_3_1.protocolLevel()) {
      return Optional.of(Fault.VERSION);
    }
    if (clientId.length() > BrokerLimits.LONGEST_CLIENT_ID) {
      return Optional.of(Fault.LONG_ID);
    }
    if (!isNamed && !packet.variableHeader().isCleanSession()) {
      return Optional.of(Fault.NO_ID);
    }
    return packet.variableHeader().willQos() > 1 ? Optional.of(Fault.WILL) : Optional.empty();
  }

  /** Identifier of the client. */
  public String clientId() {
    return clientId;
  }

  /** User name; empty if none. */
  public String user() {
    String user = packet.payload().userName();
    return packet.variableHeader().hasUserName() && user != null ? user : "";
  }

  /** The password; empty if none. */
  public byte[] password() {
    byte[] password = packet.payload().passwordInBytes();
    return password == null ? new byte[0] : password;
  }

  /** The will message; empty if none. */
  public Optional<Will> will() {
    byte[] payload = packet.payload().willMessageInBytes();
    return packet.variableHeader().isWillFlag() && packet.payload().willTopic() != null
        ? Optional.of(
            new Will(
                packet.payload().willTopic(),
                payload == null ? new byte[0] : payload,
                packet.variableHeader().willQos() > 0,
                packet.variableHeader().isWillRetain()))
        : Optional.empty();
  }

  /**
   * The packet as passed to Moquette: with the connection filter's secret as password, without the
   * will (published by the session), and without a persistent session.
   *
   * @param connection unique connection ID that replaces the client ID: Moquette confuses two
   *     connections of one client, and closes both
   */
  public MqttConnectMessage forMoquette(String connection, String name) {
    MqttConnectVariableHeader said = packet.variableHeader();
    MqttConnectVariableHeader header =
        new MqttConnectVariableHeader(
            said.name(),
            said.version(),
            true,
            true,
            false,
            0,
            false,
            true,
            said.keepAliveTimeSeconds());
    MqttConnectPayload payload =
        new MqttConnectPayload(
            connection, null, null, name, pass.getBytes(StandardCharsets.US_ASCII));
    return new MqttConnectMessage(packet.fixedHeader(), header, payload);
  }
}
