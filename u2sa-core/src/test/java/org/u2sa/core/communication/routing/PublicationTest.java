package org.u2sa.core.communication.routing;

import static org.assertj.core.api.Assertions.assertThat;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.ByteBufAllocator;
import io.netty.buffer.ByteBufUtil;
import io.netty.buffer.Unpooled;
import io.netty.buffer.UnpooledByteBufAllocator;
import io.netty.channel.embedded.EmbeddedChannel;
import io.netty.handler.codec.mqtt.MqttDecoder;
import io.netty.handler.codec.mqtt.MqttPublishMessage;
import io.netty.handler.codec.mqtt.MqttQoS;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What Netty's decoder reads of packets that were composed here. */
class PublicationTest {
  private static final String TOPIC = "u2sa/cessna/actuators/ActuatorAnnouncement/=RUDDER ü";

  private final ByteBufAllocator memory = UnpooledByteBufAllocator.DEFAULT;

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 60, 70, 126, 128, 4_096, 4_097, 16_384, 1 << 20})
  void packet_anyLength_isReadAsWhatItWasMadeOf(int bytes) {
    byte[] payload = new byte[bytes];
    new Random(bytes).nextBytes(payload);
    ByteBuf content = Unpooled.copiedBuffer(payload);
    Publication publication = new Publication(new TopicRoute(TOPIC), content, false);

    check(publication.packet(memory), payload, MqttQoS.AT_MOST_ONCE, -1);
    check(publication.packet(memory), payload, MqttQoS.AT_MOST_ONCE, -1);
    check(publication.packet(memory, 65_535), payload, MqttQoS.AT_LEAST_ONCE, 65_535);
    publication.release();

    assertThat(content.refCnt()).isEqualTo(1);
    assertThat(content.readableBytes()).isEqualTo(bytes);
    content.release();
  }

  private static void check(ByteBuf packet, byte[] payload, MqttQoS quality, int packetId) {
    EmbeddedChannel decoder = new EmbeddedChannel(new MqttDecoder(2 << 20));
    decoder.writeInbound(packet);
    MqttPublishMessage read = decoder.readInbound();
    assertThat(read.variableHeader().topicName()).isEqualTo(TOPIC);
    assertThat(read.variableHeader().packetId()).isEqualTo(packetId);
    assertThat(read.fixedHeader().qosLevel()).isEqualTo(quality);
    assertThat(read.fixedHeader().isRetain()).isFalse();
    assertThat(ByteBufUtil.getBytes(read.content())).isEqualTo(payload);
    read.release();
    assertThat(decoder.finishAndReleaseAll()).isFalse();
  }
}
