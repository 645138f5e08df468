package org.u2sa.core.communication;

import io.netty.handler.codec.mqtt.MqttConnectMessage;
import io.netty.handler.codec.mqtt.MqttConnectPayload;
import io.netty.handler.codec.mqtt.MqttConnectVariableHeader;
import io.netty.handler.codec.mqtt.MqttVersion;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.UUID;

/** The contents of a client's first packet. */
final class ConnectRequest {
  private final MqttConnectMessage packet;
  private final String clientId;
  private final String pass;

  private ConnectRequest(MqttConnectMessage packet, String clientId, String pass) {
    this.packet = packet;
    this.clientId = clientId;
    this.pass = pass;
  }

  /**
   * @param pass what the connection filter gives those it lets in, in place of a password
   */
  static ConnectRequest of(MqttConnectMessage packet, String pass) {
    String said = packet.payload().clientIdentifier();
    // mosquitto_sub leaves naming itself to the broker unless told otherwise
    String id = said == null || said.isEmpty() ? "unnamed-" + UUID.randomUUID() : said;
    return new ConnectRequest(packet, id, pass);
  }

  /** Why it is refused, regardless of the user; empty if it is not. */
  Optional<String> fault() {
    int version = packet.variableHeader().version();
    if (version != MqttVersion.MQTT_3_1_1.protocolLevel()
        && version != MqttVersion.MQTT_3_1.protocolLevel()) {
      return Optional.of("it speaks another MQTT than 3.1 and 3.1.1");
    }
    if (clientId.length() > BrokerLimits.LONGEST_CLIENT_ID) {
      return Optional.of("its client ID is too long");
    }
    if (packet.variableHeader().willQos() > 1) {
      return Optional.of("its will has QoS 2");
    }
    return Optional.empty();
  }

  String clientId() {
    return clientId;
  }

  /** Empty if it says none. */
  String user() {
    String user = packet.payload().userName();
    return packet.variableHeader().hasUserName() && user != null ? user : "";
  }

  byte[] password() {
    byte[] password = packet.payload().passwordInBytes();
    return password == null ? new byte[0] : password;
  }

  Optional<String> willTopic() {
    return packet.variableHeader().isWillFlag()
        ? Optional.ofNullable(packet.payload().willTopic())
        : Optional.empty();
  }

  byte[] will() {
    byte[] will = packet.payload().willMessageInBytes();
    return will == null ? new byte[0] : will;
  }

  int willQuality() {
    return packet.variableHeader().willQos();
  }

  boolean isWillRetained() {
    return packet.variableHeader().isWillRetain();
  }

  /**
   * The packet as Moquette gets it: with the connection filter's pass for a password, and no
   * session that would outlast the connection, as what queued in it would have no bound.
   *
   * @param connection the connection's own ID, in place of the client's: Moquette takes two
   *     connections of one client for one, and ends the newer's will and subscriptions with the
   *     older
   * @param withWill whether the client's will, if it has one, may be published
   */
  MqttConnectMessage forMoquette(String connection, String name, boolean withWill) {
    MqttConnectVariableHeader said = packet.variableHeader();
    MqttConnectVariableHeader header =
        new MqttConnectVariableHeader(
            said.name(),
            said.version(),
            true,
            true,
            withWill && said.isWillRetain(),
            withWill ? said.willQos() : 0,
            withWill && said.isWillFlag(),
            true,
            said.keepAliveTimeSeconds());
    MqttConnectPayload payload =
        new MqttConnectPayload(
            connection,
            withWill ? packet.payload().willTopic() : null,
            withWill ? packet.payload().willMessageInBytes() : null,
            name,
            pass.getBytes(StandardCharsets.US_ASCII));
    return new MqttConnectMessage(packet.fixedHeader(), header, payload);
  }
}
