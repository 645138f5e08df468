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

  /** Encodes a payload of up to 255 bytes. */
  static byte[] of(byte... payload) {
    byte[] packet = new byte[HEAD_BYTES + payload.length + TAIL_BYTES];
    packet[0] = SHORT;
    packet[1] = (byte) payload.length;
    System.arraycopy(payload, 0, packet, HEAD_BYTES, payload.length);
    int crc = RoboClawRequest.crc(0, payload, 0, payload.length); // same CRC-16/XMODEM
    packet[packet.length - 3] = (byte) (crc >> 8);
    packet[packet.length - 2] = (byte) crc;
    packet[packet.length - 1] = END;
    return packet;
  }

  /**
   * Consumes a byte.
   *
   * @return the payload if this byte completes a packet
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

  /** Resynchronises on the next start byte. */
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

  /** Discards a partial packet. */
  void reset() {
    length = 0;
  }

  /** Number of packets rejected. */
  long refused() {
    return refused;
  }
}
