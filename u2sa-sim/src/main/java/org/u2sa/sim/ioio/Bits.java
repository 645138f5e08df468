package org.u2sa.sim.ioio;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** The arguments of one message: packed bit fields, least significant first. */
record Bits(byte[] bytes, int offset, int length) {
  /** The field of some bits that begins at a bit of a byte. */
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

  /** All of it as characters. */
  String text() {
    return new String(bytes, offset, length, StandardCharsets.ISO_8859_1);
  }

  /** The bytes from an index to the end. */
  byte[] from(int index) {
    return Arrays.copyOfRange(bytes, offset + index, offset + length);
  }
}
