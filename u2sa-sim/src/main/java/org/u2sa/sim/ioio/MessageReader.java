package org.u2sa.sim.ioio;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** Splits the byte stream to the board into messages. */
final class MessageReader {
  private static final int SIX_BITS = 0x3F;

  /** Handles a complete message; returning false ends the connection. */
  interface Handler {
    boolean handle(int type, Bits arguments);
  }

  private final byte[] message = new byte[Message.LONGEST];
  private int length;

  /** Discards a partial message. */
  void reset() {
    length = 0;
  }

  /** Consumes bytes; returns false at the first message the board rejects. */
  boolean accept(byte[] bytes, int offset, int count, Handler handler) {
    for (int i = offset; i < offset + count; i++) {
      message[length++] = bytes[i];
      int missing = missing();
      if (missing < 0) {
        return false;
      }
      if (missing == 0) {
        Bits arguments = new Bits(message, 1, length - 1);
        length = 0;
        if (!handler.handle(message[0] & 0xFF, arguments)) {
          return false;
        }
      }
    }
    return true;
  }

  private int missing() {
    int type = message[0] & 0xFF;
    int fixed = Message.argumentLength(type);
    if (fixed < 0) {
      return -1;
    }
    int whole = 1 + fixed;
    if (type == Message.UART_DATA && length > 1) {
      whole += (message[1] & SIX_BITS) + 1;
    }
    return whole - length;
  }

  /** The arguments of one message: packed bit fields, least significant first. */
  record Bits(byte[] bytes, int offset, int length) {
    /** A bit field starting at a bit of a byte. */
    int field(int index, int firstBit, int bits) {
      return octet(index) >> firstBit & (1 << bits) - 1;
    }

    /** Whether a bit of a byte is set. */
    boolean flag(int index, int bit) {
      return field(index, bit, 1) == 1;
    }

    /** One byte, 0…255. */
    int octet(int index) {
      return bytes[offset + index] & 0xFF;
    }

    /** Two bytes, the low one first. */
    int word(int index) {
      return octet(index) | octet(index + 1) << 8;
    }

    /** All arguments as text. */
    String text() {
      return new String(bytes, offset, length, StandardCharsets.ISO_8859_1);
    }

    /** The bytes from an index to the end. */
    byte[] from(int index) {
      return Arrays.copyOfRange(bytes, offset + index, offset + length);
    }
  }
}
