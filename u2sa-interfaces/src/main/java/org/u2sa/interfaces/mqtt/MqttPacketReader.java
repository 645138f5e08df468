package org.u2sa.interfaces.mqtt;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.ReadableByteChannel;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** Parses packets from a broker. Not thread-safe. */
final class MqttPacketReader {
  private static final int BUFFER = 1 << 16;
  private static final int LONGEST_PACKET = (1 << 20) + (1 << 17); // payload and topic
  private static final int LONGEST_ANSWER = 1 << 13; // any packet but PUBLISH
  private static final int PUBLISH = 3;
  private static final int LENGTH_BYTES = 4;
  private static final int LENGTH_BITS = 7;
  private static final int MORE = 0x80;
  private static final int BYTE = 0xff;
  private static final int SHORT = 0xffff;
  private static final int TOPICS = 256; // must be a power of two
  private static final int LONGEST_KEPT_TOPIC = 1_024;

  interface Handler {
    /** CONNACK with return code; 0 means accepted. */
    void connected(int code);

    /** PUBLISH; a packet identifier of 0 needs no acknowledgement. */
    void message(String topic, byte[] payload, int packetId, boolean retained);

    /**
     * PUBLISH that is too long and skipped. To end the session would not help: the broker sends a
     * retained one again, and one of QoS 1 until it is acknowledged.
     */
    void skipped(String topic, int bytes, int packetId);

    /** PUBACK, SUBACK or UNSUBACK. */
    void answered(int packetId, byte[] codes);
  }

  private final Handler handler;
  private final byte[][] topicBytes = new byte[TOPICS][]; // cache of recurring topics
  private final String[] topics = new String[TOPICS];
  private ByteBuffer in = ByteBuffer.allocate(BUFFER); // unparsed bytes and free space
  private int toSkip; // bytes to come of a PUBLISH that is too long

  MqttPacketReader(Handler handler) {
    this.handler = handler;
  }

  /**
   * Reads as many available bytes as fit.
   *
   * @throws IOException if the connection is lost or the data is not valid MQTT
   */
  void read(ReadableByteChannel from) throws IOException {
    int read = from.read(in);
    if (read < 0) {
      throw new IOException("the broker ended the connection");
    }
    MqttPackets.flip(in);
    skip();
    int needed = 0;
    while (needed == 0) {
      needed = takePacket();
    }
    in.compact();
    if (needed > in.capacity()) {
      ByteBuffer larger = ByteBuffer.allocate(needed);
      MqttPackets.flip(in);
      larger.put(in);
      in = larger;
    }
  }

  private void skip() {
    int skipped = Math.min(toSkip, in.remaining());
    MqttPackets.position(in, in.position() + skipped);
    toSkip -= skipped;
  }

  /** Returns 0 if a packet was parsed, otherwise the minimum length of the next one. */
  private int takePacket() throws IOException {
    int at = in.position() + 1;
    int length = 0;
    for (int i = 0; ; i++) {
      if (at >= in.limit()) {
        return 2;
      }
      int digit = in.get(at);
      at++;
      length |= (digit & ~MORE & BYTE) << LENGTH_BITS * i;
      if ((digit & MORE) == 0) {
        break;
      }
      if (i == LENGTH_BYTES - 1) {
        throw new IOException("the broker sent a packet's length of more than 4 bytes");
      }
    }
    int head = in.get(in.position()) & BYTE;
    boolean isMessage = head >> 4 == PUBLISH;
    if (isMessage && length > LONGEST_PACKET) {
      return skipMessage(head, at, length);
    }
    if (!isMessage && length > LONGEST_ANSWER) {
      throw new IOException(
          "the broker sent a packet of "
              + length
              + " bytes and type "
              + (head >> 4)
              + "; at most "
              + LONGEST_ANSWER);
    }
    int end = at + length;
    if (end > in.limit()) {
      return end - in.position();
    }
    MqttPackets.position(in, at);
    try {
      take(head, end);
    } catch (RuntimeException e) { // packet too short
      throw new IOException("the broker sent a broken packet of type " + (head >> 4), e);
    }
    MqttPackets.position(in, end);
    return 0;
  }

  /** Like {@link #takePacket}, of a PUBLISH without its payload. */
  private int skipMessage(int head, int at, int length) throws IOException {
    int start = in.position();
    int known = in.limit() - at; // bytes after the length
    int needed = 2 + (known < 2 ? 0 : (in.getShort(at) & SHORT) + 2); // topic, packet identifier
    if (known < needed || needed == 2) {
      return at + needed - start;
    }
    MqttPackets.position(in, at);
    String topic = topic(in.getShort() & SHORT);
    handler.skipped(topic, length, packetId(head));
    MqttPackets.position(in, at);
    toSkip = length;
    skip();
    return 0;
  }

  private void take(int head, int end) throws IOException {
    switch (head >> 4) {
      case 2 -> handler.connected(in.get(in.position() + 1));
      case PUBLISH -> takeMessage(head, end);
      case 4, 9, 11 -> {
        int packetId = in.getShort() & SHORT;
        handler.answered(packetId, rest(end));
      }
      case 13 -> {
        return; // PINGRESP has no content
      }
      default -> throw new IOException("the broker sent a packet of type " + (head >> 4));
    }
  }

  private void takeMessage(int head, int end) throws IOException {
    String topic = topic(in.getShort() & SHORT);
    int packetId = packetId(head);
    handler.message(topic, rest(end), packetId, (head & 1) != 0);
  }

  private int packetId(int head) throws IOException {
    int quality = head >> 1 & 3;
    int packetId = quality == 0 ? 0 : in.getShort() & SHORT;
    if (quality > 1 || quality == 1 && packetId == 0) {
      throw new IOException(
          "the broker sent a message of QoS " + quality + " with packet identifier " + packetId);
    }
    return packetId;
  }

  private byte[] rest(int end) {
    byte[] rest = new byte[end - in.position()];
    in.get(rest);
    return rest;
  }

  private String topic(int length) {
    int from = in.arrayOffset() + in.position();
    if (length > LONGEST_KEPT_TOPIC) {
      MqttPackets.position(in, in.position() + length);
      return new String(in.array(), from, length, StandardCharsets.UTF_8);
    }
    int hash = length;
    for (int i = 0; i < length; i++) {
      hash = 31 * hash + in.array()[from + i];
    }
    int slot = hash & TOPICS - 1;
    if (!isSame(topicBytes[slot], from, length)) {
      topicBytes[slot] = Arrays.copyOfRange(in.array(), from, from + length);
      topics[slot] = new String(topicBytes[slot], StandardCharsets.UTF_8);
    }
    MqttPackets.position(in, in.position() + length);
    return topics[slot];
  }

  private boolean isSame(byte[] known, int from, int length) {
    if (known == null || known.length != length) {
      return false;
    }
    for (int i = 0; i < length; i++) {
      if (known[i] != in.array()[from + i]) {
        return false;
      }
    }
    return true;
  }
}
