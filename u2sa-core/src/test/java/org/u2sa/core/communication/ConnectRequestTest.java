package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** First packets: which are accepted, and what the client of another one is told. */
class ConnectRequestTest {
  private static final int CLEAN = 0x02;
  private static final int WILL_OF_QOS_2 = 0x16;
  private static final int WRONG_VERSION = 1;
  private static final int WRONG_ID = 2;
  private static final int NOT_AUTHORISED = 5;

  private final PacketPipeline pipeline = new PacketPipeline();

  @AfterEach
  void close() {
    pipeline.close();
  }

  private void assertRefused(int code, String reason) {
    assertThat(pipeline.taken()).isEmpty();
    assertThat(pipeline.sent()).containsExactly("20 " + code);
    assertThat(pipeline.channel.isOpen()).isFalse();
    assertThat(pipeline.log).anyMatch(line -> line.startsWith("log-in refused, " + reason));
  }

  private void assertAccepted() {
    assertThat(pipeline.taken()).containsExactly("CONNECT");
    assertThat(pipeline.channel.isOpen()).isTrue();
  }

  /** The default of HiveMQ's client and of mosquitto_sub: the broker names it. */
  @Test
  void connect_noClientIdAndCleanSession_isAcceptedNextToOthersLikeIt() {
    pipeline.send(MqttPacketBytes.connect("", 4, CLEAN));
    assertAccepted();
    try (PacketPipeline other = new PacketPipeline()) {
      other.send(MqttPacketBytes.connect("", 4, CLEAN));
      assertThat(other.taken()).containsExactly("CONNECT");
    }
  }

  @Test
  void connect_noClientIdAndLastingSession_isRefusedByItsId() {
    pipeline.send(MqttPacketBytes.connect("", 4, 0));
    assertRefused(WRONG_ID, "it has no client ID but requests a persistent session");
  }

  @Test
  void connect_clientIdAndLastingSession_isAccepted() {
    pipeline.send(MqttPacketBytes.connect("a", 4, 0));
    assertAccepted();
  }

  @Test
  void connect_longestClientId_isAccepted() {
    pipeline.send(MqttPacketBytes.connect("x".repeat(512), 4, CLEAN));
    assertAccepted();
  }

  @Test
  void connect_longerClientId_isRefusedByItsId() {
    pipeline.send(MqttPacketBytes.connect("x".repeat(513), 4, CLEAN));
    assertRefused(WRONG_ID, "its client ID is too long");
  }

  @Test
  void connect_willOfQualityTwo_isRefused() {
    pipeline.send(MqttPacketBytes.connect("a", 4, WILL_OF_QOS_2));
    assertRefused(NOT_AUTHORISED, "its will has QoS 2");
  }

  @Test
  void connect_mqtt5_isRefusedByItsVersion() {
    pipeline.send(MqttPacketBytes.connect("a", 5, CLEAN));
    assertRefused(WRONG_VERSION, "its version of MQTT is neither 3.1 nor 3.1.1");
  }
}
