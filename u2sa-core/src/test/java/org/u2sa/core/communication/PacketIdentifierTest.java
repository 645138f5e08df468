package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Packets of QoS 2, and identifiers that are 0, used again or never acknowledged. */
class PacketIdentifierTest {
  private static final String TOPIC = "u2sa/cessna/tide/Tide";
  private static final int MAX_IN_FLIGHT = 32_767;

  private final PacketPipeline pipeline = new PacketPipeline().introduced();

  @AfterEach
  void close() {
    pipeline.close();
  }

  private void assertPutOut(String kind) {
    assertThat(pipeline.channel.isOpen()).isFalse();
    assertThat(pipeline.log).anyMatch(line -> line.startsWith(kind));
  }

  private void publishLocally(int messages) {
    for (int i = 0; i < messages; i++) {
      byte[] payload = String.valueOf(i).getBytes(StandardCharsets.US_ASCII);
      pipeline.broker.router.send(TOPIC, true, false, payload, () -> {});
    }
    pipeline.pass(1);
  }

  private void acknowledge(int identifier) {
    pipeline.send(new byte[] {0x40, 2, (byte) (identifier >> 8), (byte) identifier});
    pipeline.pass(10);
  }

  /** PUBREC, PUBREL, PUBCOMP, with nothing that they could answer. */
  @ParameterizedTest
  @ValueSource(ints = {0x50, 0x62, 0x70})
  void channelRead_stepOfQualityTwo_putsTheClientOut(int first) {
    pipeline.send(new byte[] {(byte) first, 2, 0, 1});
    assertPutOut("unexpected packet");
  }

  @Test
  void channelRead_publishOfQualityTwo_putsTheClientOutUnacknowledged() {
    byte[] publish = MqttPacketBytes.publish(TOPIC, 1, 1);
    publish[0] = 0x34;
    pipeline.send(publish);

    assertThat(pipeline.sent()).isEmpty();
    assertPutOut("unexpected packet");
  }

  @Test
  void channelRead_publishOfQualityThree_isMalformed() {
    byte[] publish = MqttPacketBytes.publish(TOPIC, 1, 1);
    publish[0] = 0x36;
    pipeline.send(publish);
    assertPutOut("malformed packet");
  }

  @Test
  void channelRead_identifierZero_isMalformed() {
    pipeline.send(MqttPacketBytes.publish(TOPIC, 1, 0));
    assertPutOut("malformed packet");
  }

  @ParameterizedTest
  @ValueSource(ints = {0x40, 0x82, 0xa2})
  void channelRead_otherPacketWithIdentifierZero_isMalformed(int first) {
    byte[] content = {0, 0, 0, 1, 'a', 0};
    int length = first == 0x40 ? 2 : first == 0x82 ? 6 : 5;
    pipeline.send(MqttPacketBytes.packet(first, Arrays.copyOf(content, length)));
    assertPutOut("malformed packet");
  }

  @Test
  void channelRead_sameIdentifierAgain_eachIsAcknowledgedAndDelivered() {
    pipeline.send(MqttPacketBytes.subscribe("u2sa/#"));
    pipeline.sent();
    byte[] again = MqttPacketBytes.publish(TOPIC, 1, 7);
    pipeline.send(again);
    again[0] |= 0x08; // DUP
    pipeline.send(again);
    pipeline.send(again);

    List<String> sent = pipeline.sent();
    assertThat(sent).filteredOn("40"::equals).hasSize(3);
    assertThat(sent).filteredOn(packet -> packet.startsWith("30")).hasSize(3);
  }

  @Test
  void channelRead_acknowledgementOfNothing_isIgnored() {
    for (int i = 1; i < 100; i++) {
      acknowledge(i);
    }
    assertThat(pipeline.channel.isOpen()).isTrue();
    assertThat(pipeline.taken()).isEmpty();
  }

  @Test
  void channelRead_stopBehindHundredsOfAcknowledgements_isTakenAtOnceThoughASubscriberIsBehind() {
    pipeline.send(MqttPacketBytes.subscribeToEach("u2sa/#"));
    pipeline.sent();
    publishLocally(500);
    pipeline.session.subscriberIsBehind(true);
    ByteBuffer acknowledgements = ByteBuffer.allocate(4 * 500);
    pipeline
        .sentIdentifiers()
        .forEach(id -> acknowledgements.putShort((short) 0x4002).putShort(id.shortValue()));
    pipeline.send(acknowledgements.array());

    pipeline.send(MqttPacketBytes.publish(TOPIC, 1, 7));
    assertThat(pipeline.sent()).contains("40");
  }

  @Test
  void deliver_nothingIsAcknowledged_identifiersDifferUntilTheClientIsPutOut() {
    pipeline.send(MqttPacketBytes.subscribeToEach("u2sa/#"));
    pipeline.sent();
    publishLocally(MAX_IN_FLIGHT);
    assertThat(pipeline.channel.isOpen()).isTrue();
    Set<Integer> identifiers = new HashSet<>(pipeline.sentIdentifiers());
    assertThat(identifiers).hasSize(MAX_IN_FLIGHT).doesNotContain(0);

    publishLocally(1);
    pipeline.pass(1);
    assertPutOut("client disconnected: it is too slow");
  }

  @Test
  void deliver_someAcknowledged_theirIdentifiersAndNoOthersAreUsedAgain() {
    pipeline.send(MqttPacketBytes.subscribeToEach("u2sa/#"));
    pipeline.sent();
    publishLocally(MAX_IN_FLIGHT - 1);
    Set<Integer> unacknowledged = new HashSet<>(pipeline.sentIdentifiers());
    for (int round = 0; round < 70_000; round += 1_000) {
      for (int i = 0; i < 10; i++) {
        int one = unacknowledged.iterator().next();
        acknowledge(one);
        unacknowledged.remove(one);
      }
      publishLocally(10);
      for (int identifier : pipeline.sentIdentifiers()) {
        assertThat(unacknowledged.add(identifier)).isTrue();
      }
    }
    assertThat(pipeline.channel.isOpen()).isTrue();
  }
}
