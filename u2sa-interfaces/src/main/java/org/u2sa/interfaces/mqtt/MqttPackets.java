package org.u2sa.interfaces.mqtt;

import java.nio.Buffer;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import org.eclipse.paho.client.mqttv3.MqttConnectOptions;

/** Encodes client packets of MQTT 3.1.1 (OASIS standard, chapter 3). */
final class MqttPackets {
  static final int PUBACK_BYTES = 4;

  private static final int LONGEST_TEXT = 65_535;
  private static final int LONGEST_HEAD = 5; // type and length
  private static final int LENGTH_BITS = 7; // per byte of a packet's length
  private static final int MORE = 0x80;
  private static final byte[] NOTHING = {};

  private MqttPackets() {}

  /** CONNECT with a clean session. */
  static ByteBuffer connect(String clientId, MqttConnectOptions options) {
    byte[] id = text(clientId);
    byte[] willTopic =
        options.getWillDestination() == null ? null : text(options.getWillDestination());
    byte[] will = willTopic == null ? NOTHING : options.getWillMessage().getPayload();
    byte[] user = options.getUserName() == null ? null : text(options.getUserName());
    byte[] password = user == null ? null : text(new String(options.getPassword()));
    int flags = 0x02; // clean session
    int length = 10 + Short.BYTES + id.length;
    if (willTopic != null) {
      flags |= 0x04 | options.getWillMessage().getQos() << 3;
      flags |= options.getWillMessage().isRetained() ? 0x20 : 0;
      length += 2 * Short.BYTES + willTopic.length + will.length;
    }
    if (user != null) {
      flags |= 0xc0;
      length += 2 * Short.BYTES + user.length + password.length;
    }
    ByteBuffer packet = packet(0x10, length);
    put(packet, text("MQTT"));
    packet.put((byte) 4).put((byte) flags).putShort((short) options.getKeepAliveInterval());
    put(packet, id);
    if (willTopic != null) {
      put(packet, willTopic);
      put(packet, will);
    }
    if (user != null) {
      put(packet, user);
      put(packet, password);
    }
    return whole(packet);
  }

  /** SUBSCRIBE, all filters with the same QoS. */
  static ByteBuffer subscribe(int packetId, int quality, String... filters) {
    ByteBuffer packet = packet(0x82, Short.BYTES + length(filters) + filters.length);
    packet.putShort((short) packetId);
    for (String filter : filters) {
      put(packet, text(filter));
      packet.put((byte) quality);
    }
    return whole(packet);
  }

  static ByteBuffer unsubscribe(int packetId, String... filters) {
    ByteBuffer packet = packet(0xa2, Short.BYTES + length(filters));
    packet.putShort((short) packetId);
    for (String filter : filters) {
      put(packet, text(filter));
    }
    return whole(packet);
  }

  /** A packet without content: PINGREQ 0xc0, DISCONNECT 0xe0. */
  static ByteBuffer empty(int type) {
    ByteBuffer packet = packet(type, 0);
    return whole(packet);
  }

  /** Upper bound of the length of a {@link #putPublish}. */
  static int publishBytes(byte[] topic, byte[] payload) {
    return LONGEST_HEAD + 2 * Short.BYTES + topic.length + payload.length;
  }

  /** PUBLISH; packet identifier 1…65535 with QoS 1, 0 with QoS 0. */
  static void putPublish(
      ByteBuffer to, byte[] topic, byte[] payload, int packetId, boolean retained) {
    to.put((byte) (0x30 | (packetId == 0 ? 0 : 0x02) | (retained ? 0x01 : 0)));
    putLength(to, Short.BYTES + topic.length + (packetId == 0 ? 0 : Short.BYTES) + payload.length);
    put(to, topic);
    if (packetId != 0) {
      to.putShort((short) packetId);
    }
    to.put(payload);
  }

  static void putPubAck(ByteBuffer to, int packetId) {
    to.put((byte) 0x40).put((byte) Short.BYTES).putShort((short) packetId);
  }

  /**
   * @throws IllegalArgumentException if the text is longer than MQTT allows
   */
  static byte[] text(String text) {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    if (bytes.length > LONGEST_TEXT) {
      throw new IllegalArgumentException(
          "text of " + bytes.length + " bytes; MQTT allows " + LONGEST_TEXT);
    }
    return bytes;
  }

  private static int length(String... texts) {
    int length = 0;
    for (String text : texts) {
      length += Short.BYTES + text(text).length;
    }
    return length;
  }

  private static void put(ByteBuffer to, byte[] text) {
    to.putShort((short) text.length).put(text);
  }

  private static ByteBuffer whole(ByteBuffer packet) {
    flip(packet);
    return packet;
  }

  /** Casts to Buffer, because ByteBuffer's own override exists on Android only since 9. */
  static void flip(Buffer buffer) {
    buffer.flip();
  }

  /** Likewise. */
  static void position(Buffer buffer, int position) {
    buffer.position(position);
  }

  private static ByteBuffer packet(int type, int length) {
    ByteBuffer packet = ByteBuffer.allocate(LONGEST_HEAD + length);
    packet.put((byte) type);
    putLength(packet, length);
    return packet;
  }

  private static void putLength(ByteBuffer to, int length) {
    int left = length;
    for (; left >= MORE; left >>>= LENGTH_BITS) {
      to.put((byte) (left | MORE));
    }
    to.put((byte) left);
  }
}
