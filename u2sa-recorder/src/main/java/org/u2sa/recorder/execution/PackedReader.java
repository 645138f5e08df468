package org.u2sa.recorder.execution;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.u2sa.recorder.mcap.record.McapException;

/** Reads the encoding of {@link PackedWriter}. */
final class PackedReader {
  private static final int BITS = 7;
  private static final int MORE = 0x80;

  private final byte[] bytes;
  private int at;

  PackedReader(byte[] bytes) {
    this.bytes = bytes;
  }

  boolean hasMore() {
    return at < bytes.length;
  }

  long number() throws McapException {
    long value = 0;
    for (int shift = 0; shift < Long.SIZE; shift += BITS) {
      if (at >= bytes.length) {
        throw new McapException("an execution's record is truncated");
      }
      int one = bytes[at++];
      value |= (long) (one & (MORE - 1)) << shift;
      if ((one & MORE) == 0) {
        return value;
      }
    }
    throw new McapException("a number in an execution's record exceeds 64 bits");
  }

  long signed() throws McapException {
    long value = number();
    return value >>> 1 ^ -(value & 1);
  }

  byte[] bytes() throws McapException {
    long length = number();
    if (length < 0 || length > bytes.length - at) {
      throw new McapException("an execution's record is truncated");
    }
    at += (int) length;
    return Arrays.copyOfRange(bytes, at - (int) length, at);
  }

  String text() throws McapException {
    return new String(bytes(), StandardCharsets.UTF_8);
  }
}
