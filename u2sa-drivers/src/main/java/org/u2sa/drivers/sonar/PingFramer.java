package org.u2sa.drivers.sonar;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.function.ObjIntConsumer;

/**
 * Framing of the ping protocol: {@code BR}, payload length, message ID, sender, receiver, payload,
 * sum of all preceding bytes; little-endian (bluerobotics/ping-protocol, README).
 */
final class PingFramer {
  private static final int HEAD_BYTES = 8;
  private static final int SUM_BYTES = 2;
  private static final int MAX_PAYLOAD = 4_096; // 1,200 samples of a Ping360 and its settings

  private final byte[] bytes = new byte[HEAD_BYTES + MAX_PAYLOAD + SUM_BYTES];
  private int length;
  private long refused;

  /** Encodes a message to any device. */
  static byte[] of(int id, byte... payload) {
    ByteBuffer message =
        ByteBuffer.allocate(HEAD_BYTES + payload.length + SUM_BYTES).order(ByteOrder.LITTLE_ENDIAN);
    message.put((byte) 'B').put((byte) 'R').putShort((short) payload.length).putShort((short) id);
    message.put((byte) 0).put((byte) 0).put(payload);
    return message.putShort((short) sum(message.array(), HEAD_BYTES + payload.length)).array();
  }

  /**
   * Consumes bytes.
   *
   * @param to receives the little-endian payload and the ID of each complete message
   */
  void accept(byte[] from, int count, ObjIntConsumer<ByteBuffer> to) {
    for (int i = 0; i < count; i++) {
      bytes[length++] = from[i];
      understand(to);
    }
  }

  private void understand(ObjIntConsumer<ByteBuffer> to) {
    while (length > 0) {
      boolean canBegin =
          bytes[0] == 'B'
              && (length < 2 || bytes[1] == 'R')
              && (length < HEAD_BYTES || unsigned16(2) <= MAX_PAYLOAD);
      if (!canBegin) {
        drop(1);
        continue;
      }
      int whole = length < HEAD_BYTES ? bytes.length : HEAD_BYTES + unsigned16(2) + SUM_BYTES;
      if (length < whole) {
        return;
      }
      if (unsigned16(whole - SUM_BYTES) == (sum(bytes, whole - SUM_BYTES) & 0xFFFF)) {
        byte[] payload = Arrays.copyOfRange(bytes, HEAD_BYTES, whole - SUM_BYTES);
        to.accept(ByteBuffer.wrap(payload).order(ByteOrder.LITTLE_ENDIAN), unsigned16(4));
        drop(whole);
      } else {
        refused++;
        drop(1);
      }
    }
  }

  private void drop(int count) {
    System.arraycopy(bytes, count, bytes, 0, length - count);
    length -= count;
  }

  private int unsigned16(int at) {
    return bytes[at] & 0xFF | (bytes[at + 1] & 0xFF) << 8;
  }

  private static int sum(byte[] message, int end) {
    int sum = 0;
    for (int i = 0; i < end; i++) {
      sum += message[i] & 0xFF;
    }
    return sum;
  }

  /** Discards a partial message. */
  void reset() {
    length = 0;
  }

  /** Number of messages with a wrong checksum. */
  long refused() {
    return refused;
  }
}
