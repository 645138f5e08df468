package org.u2sa.drivers.mavlink;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;

/**
 * A frame of MAVLink 2, put together from the definition and nothing else
 * (mavlink.io/en/guide/serialization.html): low bytes first, each field at its offset in the
 * message's sorted layout, CRC-16/MCRF4XX over all but the magic and over the message's CRC_EXTRA.
 */
final class MavlinkFrame {
  private static final int HEADER = 10;

  private final int messageId;
  private final int crcExtra;
  private final ByteBuffer payload;

  /**
   * @param length of the payload [bytes]
   */
  MavlinkFrame(int messageId, int crcExtra, int length) {
    this.messageId = messageId;
    this.crcExtra = crcExtra;
    payload = ByteBuffer.allocate(length).order(ByteOrder.LITTLE_ENDIAN);
  }

  MavlinkFrame i8(int offset, int value) {
    payload.put(offset, (byte) value);
    return this;
  }

  MavlinkFrame i16(int offset, int value) {
    payload.putShort(offset, (short) value);
    return this;
  }

  MavlinkFrame i32(int offset, int value) {
    payload.putInt(offset, value);
    return this;
  }

  MavlinkFrame f32(int offset, double value) {
    payload.putFloat(offset, (float) value);
    return this;
  }

  /** From component 1 of that system. */
  byte[] from(int system) {
    return from(system, 1);
  }

  byte[] from(int system, int component) {
    int length = payload.capacity();
    while (length > 1 && payload.get(length - 1) == 0) { // zeros at the end are not sent
      length--;
    }
    byte[] frame = new byte[HEADER + length + 2];
    byte[] head = {
      (byte) 0xFD,
      (byte) length,
      0,
      0,
      0,
      (byte) system,
      (byte) component,
      (byte) messageId,
      (byte) (messageId >> 8)
    };
    System.arraycopy(head, 0, frame, 0, head.length);
    System.arraycopy(payload.array(), 0, frame, HEADER, length);
    int crc = 0xFFFF;
    for (byte each : Arrays.copyOfRange(frame, 1, HEADER + length)) {
      crc = crc(crc, each & 0xFF);
    }
    crc = crc(crc, crcExtra);
    frame[HEADER + length] = (byte) crc;
    frame[HEADER + length + 1] = (byte) (crc >> 8);
    return frame;
  }

  private static int crc(int before, int value) {
    int low = (value ^ before) & 0xFF;
    low = (low ^ low << 4) & 0xFF;
    return before >> 8 & 0xFF ^ low << 8 ^ low << 3 ^ low >> 4;
  }
}
