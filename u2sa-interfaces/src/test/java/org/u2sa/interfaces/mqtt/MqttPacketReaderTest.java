package org.u2sa.interfaces.mqtt;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.ReadableByteChannel;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
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

  @Test
  void read_whatIsNoMqtt_saysWhat() {
    assertThatThrownBy(() -> reader.read(new Wire(bytes(0x32, 1, 0), 9)))
        .isInstanceOf(IOException.class)
        .hasMessage("the broker sent a broken packet of type 3");
    assertThatThrownBy(() -> fresh().read(new Wire(bytes(0x10, 0), 9)))
        .isInstanceOf(IOException.class)
        .hasMessage("the broker sent a packet of type 1");
    assertThatThrownBy(() -> fresh().read(new Wire(bytes(0x30, 0xff, 0xff, 0xff, 0xff, 1), 9)))
        .isInstanceOf(IOException.class)
        .hasMessage("the broker sent a packet's length of more than 4 bytes");
    assertThatThrownBy(() -> fresh().read(new Wire(bytes(0x30, 0xff, 0xff, 0xff, 0x7f), 9)))
        .isInstanceOf(IOException.class)
        .hasMessageStartingWith("the broker sent a packet of 268435455 bytes");
  }

  @Test
  void read_longAnswer_isRefusedByItsLengthAlone() {
    for (int type : new int[] {0x20, 0x40, 0x90, 0xb0, 0xd0}) {
      assertThatThrownBy(() -> fresh().read(new Wire(bytes(type, 0x81, 0x40), 9)))
          .isInstanceOf(IOException.class)
          .hasMessage(
              "the broker sent a packet of 8193 bytes and type " + (type >> 4) + "; at most 8192");
    }
  }

  @Test
  void read_messagesThatNoSubscriptionAskedFor_areRefused() {
    for (int[] wrong : new int[][] {{0x34, 0, 7}, {0x36, 0, 7}, {0x32, 0, 0}}) {
      assertThatThrownBy(
              () -> fresh().read(new Wire(bytes(wrong[0], 5, 0, 1, 'a', wrong[1], wrong[2]), 9)))
          .isInstanceOf(IOException.class)
          .hasMessage(
              "the broker sent a message of QoS "
                  + (wrong[0] >> 1 & 3)
                  + " with packet identifier "
                  + wrong[2]);
    }
    assertThat(heard).isEmpty();
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

  private MqttPacketReader fresh() {
    return new MqttPacketReader(new Noting());
  }

  private static ByteBuffer bytes(int... values) {
    ByteBuffer bytes = ByteBuffer.allocate(values.length);
    for (int value : values) {
      bytes.put((byte) value);
    }
    bytes.flip();
    return bytes;
  }
}
