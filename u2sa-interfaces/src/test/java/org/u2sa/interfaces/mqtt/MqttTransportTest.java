package org.u2sa.interfaces.mqtt;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;

/** What the way to a broker is made of. */
class MqttTransportTest {
  private static final MessageCodec CODEC = new MessageCodec(StandardTypes.registry());

  private static MqttTransport to(int port, String systemId) {
    return new MqttTransport("127.0.0.1", port, systemId, CODEC);
  }

  @Test
  void port_outsideOfTcps_isRefused() {
    assertThatThrownBy(() -> to(0, "cessna")).hasMessage("port: 0 is outside 1…65535");
    assertThatThrownBy(() -> to(65_536, "cessna")).hasMessage("port: 65536 is outside 1…65535");
    assertThatCode(() -> to(1, "cessna")).doesNotThrowAnyException();
    assertThatCode(() -> to(65_535, "cessna")).doesNotThrowAnyException();
  }

  @Test
  void systemId_oneAllOrNone_isCheckedHereToo() {
    assertThat(to(1883, "cessna").systemId()).isEqualTo("cessna");
    assertThat(to(1883, Topic.ANY_SYSTEM).systemId()).isEqualTo("+");
    assertThatThrownBy(() -> to(1883, "#")).isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void ofSystem_other_isTheSameWayToThatSystem() {
    MqttTransport all = to(1883, "cessna").waiting(2.0).ofSystem(Topic.ANY_SYSTEM);

    assertThat(all.systemId()).isEqualTo("+");
    assertThat(all.ofSystem("boat").systemId()).isEqualTo("boat");
  }
}
