package org.u2sa.drivers.motor;

import java.util.Arrays;

/**
 * Framing of VESC's serial protocol: 2, length, payload, CRC-16 of the payload, 3 (vedderb/bldc,
 * {@code comm/packet.c}).
 */
final class VescPacket {
  private static final int SHORT = 2;
  private static final int END = 3;
  private static final int HEAD_BYTES = 2;
  private static final int TAIL_BYTES = 3;
  private static final int LONGEST = 255;

  private final byte[] bytes = new byte[HEAD_BYTES + LONGEST + TAIL_BYTES];
  private int length;
  private long refused;

  /** A payload of at most 255 bytes as it is sent. */
  static byte[] of(byte... payload) {
    byte[] packet = new byte[HEAD_BYTES + payload.length + TAIL_BYTES];
    packet[0] = SHORT;
    packet[1] = (byte) payload.length;
    System.arraycopy(payload, 0, packet, HEAD_BYTES, payload.length);
    int crc = RoboClawRequest.crc(0, payload, 0, payload.length); // XMODEM's, too
    packet[packet.length - 3] = (byte) (crc >> 8);
    packet[packet.length - 2] = (byte) crc;
    packet[packet.length - 1] = END;
    return packet;
  }

  /**
   * Takes the next byte.
   *
   * @return the payload that it completes; empty if it completes none
   */
  byte[] accept(byte each) {
    bytes[length++] = each;
    while (length > 0) {
      if (bytes[0] != SHORT) {
        drop();
      } else if (length < HEAD_BYTES || length < whole()) {
        return new byte[0];
      } else if (isRight()) {
        int whole = whole();
        byte[] payload = Arrays.copyOfRange(bytes, HEAD_BYTES, whole - TAIL_BYTES);
        System.arraycopy(bytes, whole, bytes, 0, length - whole);
        length -= whole;
        return payload;
      } else {
        refused++;
        drop();
      }
    }
    return new byte[0];
  }

  /** Looks for a packet that begins later. */
  private void drop() {
    int next = 1;
    while (next < length && bytes[next] != SHORT) {
      next++;
    }
    System.arraycopy(bytes, next, bytes, 0, length - next);
    length -= next;
  }

  private int whole() {
    return HEAD_BYTES + (bytes[1] & 0xFF) + TAIL_BYTES;
  }

  private boolean isRight() {
    int end = whole() - TAIL_BYTES;
    return end > HEAD_BYTES
        && bytes[end + 2] == END
        && RoboClawRequest.crc(0, bytes, HEAD_BYTES, end) == RoboClawRequest.unsigned16(bytes, end);
  }

  /** Forgets what is half received. */
  void reset() {
    length = 0;
  }

  /** Packets with a wrong checksum or end so far. */
  long refused() {
    return refused;
  }
}
