package org.u2sa.core.communication;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.netty.handler.codec.mqtt.MqttConnectMessage;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** That Moquette takes only those whom the filter has admitted. */
class AdmissionPassTest {
  private final PacketPipeline client = new PacketPipeline();

  @AfterEach
  void close() {
    client.close();
  }

  private byte[] passOfAnAdmittedClient() {
    client.send(MqttPacketBytes.connect("client", 0));
    MqttConnectMessage connect = client.channel.readInbound();
    return connect.payload().passwordInBytes();
  }

  @Test
  void letIn_admittedByTheFilter_isTaken() {
    assertThat(client.filter.letIn(passOfAnAdmittedClient())).isTrue();
  }

  @Test
  void letIn_anythingElse_hasToComeAgain() {
    byte[] changed = passOfAnAdmittedClient();
    changed[0] ^= 1;
    for (byte[] wrong : new byte[][] {null, {}, "password".getBytes(US_ASCII), changed}) {
      assertThatThrownBy(() -> client.filter.letIn(wrong))
          .isInstanceOf(ConnectionFilter.StartingException.class)
          .hasMessageContaining("the client will retry");
    }
  }

  @Test
  void pass_ofEachBroker_isAnotherAndHardToGuess() {
    PacketPipeline other = new PacketPipeline();
    assertThat(client.broker.pass()).hasSizeGreaterThan(40).isNotEqualTo(other.broker.pass());
    assertThat(other.filter.letIn(other.broker.pass().getBytes(US_ASCII))).isTrue();
    other.close();
  }
}
