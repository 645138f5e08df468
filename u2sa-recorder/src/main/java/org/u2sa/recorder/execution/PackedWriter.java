package org.u2sa.recorder.execution;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * Growable byte buffer with variable-length integers (LEB128): seven bits per byte, lowest first.
 */
final class PackedWriter {
  private static final int FIRST_CAPACITY = 256;
  private static final int BITS = 7;
  private static final int MORE = 0x80;

  private byte[] bytes = new byte[FIRST_CAPACITY];
  private int length;

  /** Appends an unsigned number. */
  PackedWriter number(long value) {
    long rest = value;
    while ((rest & -MORE) != 0) {
      add((int) (rest & (MORE - 1)) | MORE);
      rest >>>= BITS;
    }
    add((int) rest);
    return this;
  }

  /** Appends a signed number; short near zero. */
  PackedWriter signed(long value) {
    return number(value << 1 ^ value >> (Long.SIZE - 1));
  }

  PackedWriter bytes(byte[] all) {
    number(all.length);
    require(all.length);
    System.arraycopy(all, 0, bytes, length, all.length);
    length += all.length;
    return this;
  }

  PackedWriter text(String text) {
    return bytes(text.getBytes(StandardCharsets.UTF_8));
  }

  private void add(int value) {
    require(1);
    bytes[length++] = (byte) value;
  }

  private void require(int more) {
    if (length + more > bytes.length) {
      bytes = Arrays.copyOf(bytes, Math.max(2 * bytes.length, length + more));
    }
  }

  int length() {
    return length;
  }

  void clear() {
    length = 0;
  }

  byte[] toBytes() {
    return Arrays.copyOf(bytes, length);
  }
}
