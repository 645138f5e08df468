package org.u2sa.interfaces.mqtt;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.ReadableByteChannel;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What a broker says, in whatever pieces it comes. */
class MqttPacketReaderTest {
  private static final String TOPIC = "u2sa/cessna/state/StateInformation";

  private final List<String> heard = new ArrayList<>();
  private final MqttPacketReader reader = new MqttPacketReader(new Noting());

  private final class Noting implements MqttPacketReader.Handler {
    @Override
    public void connected(int code) {
      heard.add("connected " + code);
    }

    @Override
    public void message(String topic, byte[] payload, int packetId, boolean retained) {
      heard.add(topic + " " + Arrays.hashCode(payload) + " " + packetId + " " + retained);
    }

    @Override
    public void skipped(String topic, int bytes, int packetId) {
      heard.add("skipped " + topic + " " + bytes + " " + packetId);
    }

    @Override
    public void answered(int packetId, byte[] codes) {
      heard.add("answered " + packetId + " " + Arrays.toString(codes));
    }
  }

  /** A network that brings a number of bytes at a time, then ends. */
  private static final class Wire implements ReadableByteChannel {
    private final ByteBuffer bytes;
    private final int atATime;

    Wire(ByteBuffer bytes, int atATime) {
      this.bytes = bytes;
      this.atATime = atATime;
    }

    @Override
    public int read(ByteBuffer into) {
      if (!bytes.hasRemaining()) {
        return -1;
      }
      int count = Math.min(Math.min(atATime, into.remaining()), bytes.remaining());
      for (int i = 0; i < count; i++) {
        into.put(bytes.get());
      }
      return count;
    }

    @Override
    public boolean isOpen() {
      return true;
    }

    @Override
    public void close() {
      // nothing to close
    }
  }

  private void read(ByteBuffer bytes, int atATime) {
    Wire wire = new Wire(bytes, atATime);
    assertThatThrownBy(
            () -> {
              while (true) {
                reader.read(wire);
              }
            })
        .isInstanceOf(IOException.class)
        .hasMessage("the broker ended the connection");
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 7, 1_000, 1 << 20})
  void read_packetsInPieces_areWhole(int atATime) {
    byte[] large = new byte[200_000];
    new Random(1).nextBytes(large);
    byte[] topic = MqttPackets.text(TOPIC);
    ByteBuffer bytes = ByteBuffer.allocate(1 << 19);
    bytes.put(new byte[] {0x20, 2, 0, 5});
    MqttPackets.putPublish(bytes, topic, new byte[0], 0, false);
    MqttPackets.putPublish(bytes, topic, large, 65_535, true);
    bytes.put(new byte[] {(byte) 0xd0, 0});
    bytes.put(new byte[] {(byte) 0x90, 4, 1, 2, 1, (byte) 0x80});
    MqttPackets.putPubAck(bytes, 300);
    MqttPackets.putPublish(bytes, MqttPackets.text("other"), new byte[] {7}, 0, false);
    bytes.flip();

    read(bytes, atATime);

    assertThat(heard)
        .containsExactly(
            "connected 5",
            TOPIC + " " + Arrays.hashCode(new byte[0]) + " 0 false",
            TOPIC + " " + Arrays.hashCode(large) + " 65535 true",
            "answered 258 [1, -128]",
            "answered 300 []",
            "other " + Arrays.hashCode(new byte[] {7}) + " 0 false");
  }

  @Test
  void read_topicsThatShareASlot_areNotMistaken() {
    ByteBuffer bytes = ByteBuffer.allocate(1 << 20);
    for (int i = 0; i < 2_000; i++) {
      MqttPackets.putPublish(
          bytes, MqttPackets.text(TOPIC + i % 700), new byte[] {(byte) i}, 0, false);
    }
    bytes.flip();

    read(bytes, 1 << 16);

    assertThat(heard).hasSize(2_000);
    for (int i = 0; i < 2_000; i++) {
      assertThat(heard.get(i)).startsWith(TOPIC + i % 700 + " ");
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          32 01 00          | broken packet of type 3
          10 00             | packet of type 1
          30 ff ff ff ff 01 | packet's length of more than 4 bytes
          20 81 40          | packet of 8193 bytes and type 2; at most 8192
          40 81 40          | packet of 8193 bytes and type 4; at most 8192
          90 81 40          | packet of 8193 bytes and type 9; at most 8192
          b0 81 40          | packet of 8193 bytes and type 11; at most 8192
          d0 81 40          | packet of 8193 bytes and type 13; at most 8192
          34 05 00 01 61 00 07 | message of QoS 2 with packet identifier 7
          36 05 00 01 61 00 07 | message of QoS 3 with packet identifier 7
          32 05 00 01 61 00 00 | message of QoS 1 with packet identifier 0
          """)
  void read_notMqttOrNotRequested_isRefused(String hex, String what) {
    byte[] bytes = HexFormat.ofDelimiter(" ").parseHex(hex);
    assertThatThrownBy(() -> reader.read(new Wire(ByteBuffer.wrap(bytes), 9)))
        .isInstanceOf(IOException.class)
        .hasMessage("the broker sent a " + what);
    assertThat(heard).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 7, 1_000, 1 << 20, 1 << 22})
  void read_messagesThatAreTooLong_areSkipped(int atATime) {
    byte[] tooLong = new byte[(1 << 20) + (1 << 17)];
    new Random(2).nextBytes(tooLong);
    ByteBuffer bytes = ByteBuffer.allocate(1 << 22);
    byte[] topic = MqttPackets.text(TOPIC);
    MqttPackets.putPublish(bytes, topic, tooLong, 0, true);
    MqttPackets.putPublish(bytes, topic, new byte[] {7}, 1, false);
    MqttPackets.putPublish(bytes, MqttPackets.text("other"), tooLong, 65_535, false);
    MqttPackets.putPublish(bytes, topic, new byte[] {8}, 0, false);
    bytes.flip();

    read(bytes, atATime);

    assertThat(heard)
        .containsExactly(
            "skipped " + TOPIC + " " + (tooLong.length + topic.length + 2) + " 0",
            TOPIC + " " + Arrays.hashCode(new byte[] {7}) + " 1 false",
            "skipped other " + (tooLong.length + 5 + 4) + " 65535",
            TOPIC + " " + Arrays.hashCode(new byte[] {8}) + " 0 false");
  }

  @Test
  void read_topicLongerThanAnyOfOurs_isRead() {
    String topic = "x".repeat(2_000);
    ByteBuffer bytes = ByteBuffer.allocate(3_000);
    MqttPackets.putPublish(bytes, MqttPackets.text(topic), new byte[] {7}, 0, false);
    bytes.flip();

    read(bytes, 1_000);

    assertThat(heard).containsExactly(topic + " " + Arrays.hashCode(new byte[] {7}) + " 0 false");
  }
}
