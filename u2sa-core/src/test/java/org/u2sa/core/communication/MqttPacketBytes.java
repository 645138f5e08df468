package org.u2sa.core.communication;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** Packets of MQTT 3.1.1 as bytes, right and wrong ones (OASIS standard, chapter 3). */
final class MqttPacketBytes {
  static final byte[] PINGREQ = {(byte) 0xc0, 0};

  private MqttPacketBytes() {}

  private interface Content {
    void writeTo(DataOutputStream out) throws IOException;
  }

  private static byte[] packet(int first, Content content) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try {
      content.writeTo(new DataOutputStream(bytes));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return packet(first, bytes.toByteArray());
  }

  /** A packet with that first byte. */
  static byte[] packet(int first, byte[] content) {
    ByteArrayOutputStream packet = new ByteArrayOutputStream();
    packet.write(first);
    int left = content.length;
    do {
      packet.write(left % 128 | (left >= 128 ? 0x80 : 0));
      left /= 128;
    } while (left > 0);
    packet.writeBytes(content);
    return packet.toByteArray();
  }

  /** CONNECT with a clean session, and as many bytes of will as asked for; 0: no will. */
  static byte[] connect(String clientId, int willBytes) {
    return packet(
        0x10,
        out -> {
          out.writeUTF("MQTT");
          out.write(4);
          out.write(willBytes == 0 ? 0x02 : 0x06);
          out.writeShort(60);
          out.writeUTF(clientId);
          if (willBytes > 0) {
            out.writeUTF(PacketPipeline.TOPIC);
            out.writeShort(willBytes);
            out.write(new byte[willBytes]);
          }
        });
  }

  /**
   * CONNECT as a protocol version has it.
   *
   * @param version 4: MQTT 3.1.1; 5: MQTT 5, without properties
   * @param flags 0x02 clean session; with 0x04 there is a will
   */
  static byte[] connect(String clientId, int version, int flags) {
    return packet(
        0x10,
        out -> {
          out.writeUTF("MQTT");
          out.write(version);
          out.write(flags);
          out.writeShort(60);
          if (version == 5) {
            out.write(0);
          }
          out.writeUTF(clientId);
          if ((flags & 0x04) != 0) {
            out.writeUTF(PacketPipeline.TOPIC);
            out.writeUTF("will");
          }
        });
  }

  /** CONNECT with a will, of MQTT 3.1.1. */
  static byte[] connect(String clientId, int flags, String willTopic, byte[] will) {
    return packet(
        0x10,
        out -> {
          out.writeUTF("MQTT");
          out.write(4);
          out.write(flags);
          out.writeShort(60);
          out.writeUTF(clientId);
          out.writeUTF(willTopic);
          out.writeShort(will.length);
          out.write(will);
        });
  }

  /** CONNECT with a clean session, as a user. */
  static byte[] connectAs(String user, String password, String clientId) {
    return packet(
        0x10,
        out -> {
          out.writeUTF("MQTT");
          out.write(4);
          out.write(0xc2);
          out.writeShort(60);
          out.writeUTF(clientId);
          out.writeUTF(user);
          out.writeUTF(password);
        });
  }

  /** CONNECT with a clean session and a will of QoS 0, as a user. */
  static byte[] connectAs(String user, String password, String clientId, String willTopic) {
    return packet(
        0x10,
        out -> {
          out.writeUTF("MQTT");
          out.write(4);
          out.write(0xc6);
          out.writeShort(60);
          out.writeUTF(clientId);
          out.writeUTF(willTopic);
          out.writeUTF("will");
          out.writeUTF(user);
          out.writeUTF(password);
        });
  }

  /** PUBLISH of zeros at QoS 0. */
  static byte[] publish(String topic, int payloadBytes) {
    return packet(
        0x30,
        out -> {
          out.writeUTF(topic);
          out.write(new byte[payloadBytes]);
        });
  }

  /** PUBLISH of zeros at QoS 1. */
  static byte[] publish(String topic, int payloadBytes, int packetId) {
    return packet(
        0x32,
        out -> {
          out.writeUTF(topic);
          out.writeShort(packetId);
          out.write(new byte[payloadBytes]);
        });
  }

  /** PUBLISH at QoS 1, to be retained, with a byte for each letter. */
  static byte[] retained(String topic, String payload) {
    return packet(
        0x33,
        out -> {
          out.writeUTF(topic);
          out.writeShort(1);
          out.write(payload.getBytes(StandardCharsets.ISO_8859_1));
        });
  }

  /** SUBSCRIBE at QoS 1. */
  static byte[] subscribeToEach(String filter) {
    return packet(
        0x82,
        out -> {
          out.writeShort(1);
          out.writeUTF(filter);
          out.write(1);
        });
  }

  /** SUBSCRIBE at QoS 0. */
  static byte[] subscribe(String... filters) {
    return packet(
        0x82,
        out -> {
          out.writeShort(1);
          for (String filter : filters) {
            out.writeUTF(filter);
            out.write(0);
          }
        });
  }

  static byte[] unsubscribe(String... filters) {
    return packet(
        0xa2,
        out -> {
          out.writeShort(1);
          for (String filter : filters) {
            out.writeUTF(filter);
          }
        });
  }

  /** SUBSCRIBE or UNSUBSCRIBE of about as many bytes, with as many filters as that allows. */
  static byte[] manyFilters(boolean subscribes, int bytes) {
    String[] filters = new String[bytes / (subscribes ? 4 : 3)];
    Arrays.fill(filters, "a");
    return subscribes ? subscribe(filters) : unsubscribe(filters);
  }

  /** UNSUBSCRIBE with many filters, the last of which claims more bytes than the packet has. */
  static byte[] unsubscribeBeyondItsEnd(int filters) {
    return packet(
        0xa2,
        out -> {
          out.writeShort(1);
          for (int i = 0; i < filters; i++) {
            out.write("\0\1a".getBytes(StandardCharsets.US_ASCII));
          }
          out.writeShort(65_535);
        });
  }
}
