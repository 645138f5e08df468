package org.u2sa.sim.sensor;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** Builds one UBX message: two sync characters, class, id, length, payload, Fletcher checksum. */
final class UbxMessage {
  static final int SYNC_1 = 0xB5;
  static final int SYNC_2 = 0x62;
  static final int HEADER = 6;
  static final int CHECKSUM = 2;

  private final ByteBuffer buffer;
  private final int length;

  UbxMessage(int messageClass, int id, int length) {
    this.length = length;
    buffer = ByteBuffer.allocate(HEADER + length + CHECKSUM).order(ByteOrder.LITTLE_ENDIAN);
    buffer.put((byte) SYNC_1).put((byte) SYNC_2).put((byte) messageClass).put((byte) id);
    buffer.putShort((short) length);
  }

  UbxMessage u1(long value) {
    buffer.put((byte) value);
    return this;
  }

  UbxMessage u2(long value) {
    buffer.putShort((short) value);
    return this;
  }

  /** Appends a signed 32-bit integer. */
  UbxMessage i4(long value) {
    buffer.putInt((int) value);
    return this;
  }

  /** Appends a value in units of {@code 1 / scale}, rounded to a signed 32-bit integer. */
  UbxMessage i4(double value, double scale) {
    return i4(Math.round(value * scale));
  }

  UbxMessage skip(int bytes) {
    buffer.position(buffer.position() + bytes);
    return this;
  }

  /** The message with its checksum. */
  byte[] bytes() {
    if (buffer.position() != HEADER + length) {
      throw new IllegalStateException(
          "payload of " + (buffer.position() - HEADER) + " bytes, declared " + length);
    }
    byte[] bytes = buffer.array();
    int sum = checksum(bytes, 2, HEADER + length);
    bytes[HEADER + length] = (byte) (sum >> 8);
    bytes[HEADER + length + 1] = (byte) sum;
    return bytes;
  }

  /** 8-bit Fletcher checksum of a range; the first sum is in the upper byte. */
  static int checksum(byte[] bytes, int from, int to) {
    int a = 0;
    int b = 0;
    for (int i = from; i < to; i++) {
      a = (a + bytes[i]) & 0xFF;
      b = (b + a) & 0xFF;
    }
    return a << 8 | b;
  }

  /** Extracts UBX messages from host bytes; other bytes are skipped, as by real receivers. */
  static final class Reader {
    private static final int LONGEST = 512;

    /** Handles a message with a valid checksum. */
    interface Listener {
      void request(int messageClass, int id, byte[] payload);
    }

    private final Listener listener;
    private final byte[] message = new byte[HEADER + LONGEST + CHECKSUM];
    private int size;

    Reader(Listener listener) {
      this.listener = listener;
    }

    void accept(byte[] bytes, int length) {
      for (int i = 0; i < length; i++) {
        accept(bytes[i]);
      }
    }

    private void accept(byte octet) {
      message[size++] = octet;
      if (size == 1 && (octet & 0xFF) != SYNC_1 || size == 2 && (octet & 0xFF) != SYNC_2) {
        size = (octet & 0xFF) == SYNC_1 ? 1 : 0;
        message[0] = octet;
        return;
      }
      if (size < HEADER) {
        return;
      }
      int length = message[4] & 0xFF | (message[5] & 0xFF) << 8;
      if (length > LONGEST) {
        size = 0;
      } else if (size == HEADER + length + CHECKSUM) {
        size = 0;
        finish(length);
      }
    }

    private void finish(int length) {
      int end = HEADER + length;
      int said = (message[end] & 0xFF) << 8 | message[end + 1] & 0xFF;
      if (checksum(message, 2, end) == said) {
        byte[] payload = new byte[length];
        System.arraycopy(message, HEADER, payload, 0, length);
        listener.request(message[2] & 0xFF, message[3] & 0xFF, payload);
      }
    }
  }
}
