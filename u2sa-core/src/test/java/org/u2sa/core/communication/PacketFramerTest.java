package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.core.communication.limit.BrokerLimits;

/** How often bytes are decoded, and which packets never are. */
class PacketFramerTest {
  private static final String PINGRESP = "d0";
  private static final int MEGABYTE = 1 << 20;
  private static final String MALFORMED = "malformed packet";

  private final PacketPipeline pipeline = new PacketPipeline().introduced();

  @AfterEach
  void close() {
    pipeline.close();
  }

  private void assertPutOut() {
    assertThat(pipeline.channel.isOpen()).isFalse();
    assertThat(pipeline.log).anyMatch(line -> line.contains(MALFORMED));
  }

  @Test
  void channelRead_oneByteAtATime_decoderGetsEachPacketOnceWhenItIsComplete() {
    byte[] publish = MqttPacketBytes.publish(PacketPipeline.TOPIC, 20_000);
    byte[] subscribe = MqttPacketBytes.subscribe("u2sa/#", "u2sa/cessna/#");
    byte[] unsubscribe = MqttPacketBytes.unsubscribe("u2sa/#");

    for (byte[] packet : List.of(publish, MqttPacketBytes.PINGREQ, subscribe, unsubscribe)) {
      pipeline.drip(packet);
      assertThat(pipeline.decoded).containsExactly(packet.length);
      pipeline.decoded.clear();
      pipeline.pass(1_000);
    }
    assertThat(pipeline.sent()).filteredOn(PINGRESP::equals).hasSize(1);
  }

  @Test
  void channelRead_packetsCutAnywhere_areTheSamePackets() {
    byte[] publish = MqttPacketBytes.publish("u2sa/x/state/StateInformation", 200);
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    all.writeBytes(MqttPacketBytes.PINGREQ);
    all.writeBytes(publish);
    all.writeBytes(MqttPacketBytes.PINGREQ);
    all.writeBytes(MqttPacketBytes.PINGREQ);
    byte[] bytes = all.toByteArray();

    for (int cut = 0; cut <= bytes.length; cut++) {
      pipeline.send(Arrays.copyOf(bytes, cut));
      pipeline.send(Arrays.copyOfRange(bytes, cut, bytes.length));
      assertThat(pipeline.sent()).filteredOn(PINGRESP::equals).hasSize(3);
      assertThat(pipeline.decoded.stream().mapToInt(length -> length).sum())
          .isEqualTo(bytes.length);
      pipeline.decoded.clear();
      pipeline.pass(1_000);
    }
    assertThat(pipeline.channel.isOpen()).isTrue();
  }

  /** Of each type, a packet that claims a megabyte: refused as soon as its length is there. */
  @ParameterizedTest
  @ValueSource(
      ints = {
        0x00, 0x10, 0x20, 0x40, 0x50, 0x62, 0x70, 0x82, 0x90, 0xa2, 0xb0, 0xc0, 0xd0, 0xe0, 0xf0
      })
  void channelRead_longPacketOtherThanPublish_isRefusedByItsLengthAndNeverDecoded(int first) {
    int received = pipeline.drip(MqttPacketBytes.packet(first, new byte[MEGABYTE]));

    assertThat(received).isEqualTo(4); // the type and three bytes of length
    assertThat(pipeline.decoded).isEmpty();
    assertPutOut();
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void channelRead_megabyteOfFilters_isRefusedAndNeverDecoded(boolean subscribes) {
    pipeline.send(MqttPacketBytes.manyFilters(subscribes, MEGABYTE));

    assertThat(pipeline.decoded).isEmpty();
    assertPutOut();
  }

  @Test
  void channelRead_longestSubscribe_isDecodedAndOneByteMoreIsNot() {
    int filter = BrokerLimits.LONGEST_CONTROL_PACKET - 8; // header, identifier, its length, QoS
    pipeline.send(MqttPacketBytes.subscribe("x".repeat(filter)));
    assertThat(pipeline.decoded).hasSize(1);
    assertThat(pipeline.log).anyMatch(line -> line.contains("a filter is too long"));
    assertThat(pipeline.channel.isOpen()).isTrue();

    pipeline.send(MqttPacketBytes.subscribe("x".repeat(filter + 1)));
    assertThat(pipeline.decoded).hasSize(1);
    assertPutOut();
  }

  @Test
  void channelRead_longestPublish_isDecodedAndOneByteMoreIsNot() {
    int header = 4 + Short.BYTES + PacketPipeline.TOPIC.length();
    int payload = BrokerLimits.LONGEST_PACKET - header;
    pipeline.send(MqttPacketBytes.publish(PacketPipeline.TOPIC, payload));
    assertThat(pipeline.decoded).hasSize(1);
    assertThat(pipeline.channel.isOpen()).isTrue();

    pipeline.send(MqttPacketBytes.publish(PacketPipeline.TOPIC, payload + 1));
    assertThat(pipeline.decoded).hasSize(1);
    assertPutOut();
  }

  @Test
  void channelRead_lengthOfFiveBytes_isRefused() {
    pipeline.send(new byte[] {0x30, -1, -1, -1, -1, 0});

    assertThat(pipeline.decoded).isEmpty();
    assertPutOut();
  }

  /** The decoder would begin the packet again with each further byte. */
  @Test
  void channelRead_contentsBeyondThePacketsEnd_areDecodedOnce() {
    pipeline.send(MqttPacketBytes.unsubscribeBeyondItsEnd(2_000));
    int dripped = pipeline.drip(new byte[1_000]);

    assertThat(dripped).isZero();
    assertThat(pipeline.decoded).hasSize(1);
    assertPutOut();
  }

  @Test
  void channelRead_completePacketBeforeARefusedOne_isTaken() {
    ByteArrayOutputStream both = new ByteArrayOutputStream();
    both.writeBytes(MqttPacketBytes.PINGREQ);
    both.writeBytes(MqttPacketBytes.packet(0x82, new byte[MEGABYTE]));
    pipeline.send(both.toByteArray());

    assertThat(pipeline.decoded).containsExactly(MqttPacketBytes.PINGREQ.length);
    assertPutOut();
  }

  @Test
  void channelRead_afterARefusedPacket_nothingIsDecodedAnyMore() {
    pipeline.channel.pipeline().remove(ClientSession.class); // so that nobody closes the channel
    assertThat(pipeline.channel.isOpen()).isTrue();
    pipeline.send(new byte[] {0x30, -1, -1, -1, -1, 0});
    pipeline.send(MqttPacketBytes.PINGREQ);

    assertThat(pipeline.decoded).isEmpty();
  }

  @Test
  void channelRead_longConnectOfAStranger_isRefusedByItsLength() {
    try (PacketPipeline stranger = new PacketPipeline()) {
      int received = stranger.drip(MqttPacketBytes.connect("x", 60_000));

      assertThat(received).isEqualTo(4);
      assertThat(stranger.decoded).isEmpty();
      assertThat(stranger.channel.isOpen()).isFalse();
    }
    try (PacketPipeline stranger = new PacketPipeline()) {
      byte[] connect = MqttPacketBytes.connect("x", BrokerLimits.LONGEST_WILL);
      assertThat(stranger.drip(connect)).isEqualTo(connect.length);
      assertThat(stranger.decoded).containsExactly(connect.length);
      assertThat(stranger.taken()).containsExactly("CONNECT");
    }
  }
}
