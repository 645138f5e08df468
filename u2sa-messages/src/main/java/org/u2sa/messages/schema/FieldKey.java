package org.u2sa.messages.schema;

import java.nio.ByteBuffer;
import java.util.Arrays;

/**
 * A field's name as it is on the wire, made once: written and recognised eight bytes at a time.
 * Immutable.
 */
final class FieldKey {
  private final byte[] bytes;
  private final int length;
  private final long[] words; // the bytes, big-endian; the last word is filled up with zeros
  private final long first; // of them: most names are that short
  private final long second; // 0 if there is none
  private final long firstMask; // of the bits of the first word that are the name's
  private final long secondMask; // likewise

  FieldKey(String name) {
    CborOutput out = new CborOutput();
    out.text(name);
    bytes = out.toBytes();
    length = bytes.length;
    words = new long[(length + Long.BYTES - 1) / Long.BYTES];
    ByteBuffer view = ByteBuffer.wrap(Arrays.copyOf(bytes, words.length * Long.BYTES));
    for (int i = 0; i < words.length; i++) {
      words[i] = view.getLong(i * Long.BYTES);
    }
    first = words[0];
    second = words.length > 1 ? words[1] : 0L;
    firstMask = mask(length);
    secondMask = mask(length - Long.BYTES);
  }

  /** The bits of a word that are those of so many bytes; all of them, if there are more. */
  private static long mask(int count) {
    int kept = Math.max(0, Math.min(Long.BYTES, count));
    return kept == 0 ? 0L : -1L << (Long.BYTES - kept) * Byte.SIZE;
  }

  int length() {
    return length;
  }

  /** How many bytes {@link #put} touches. */
  int room() {
    return words.length * Long.BYTES;
  }

  /** Writes the name; what follows it within {@link #room()} is overwritten by zeros. */
  void put(ByteBuffer into, int at) {
    into.putLong(at, first);
    if (length > Long.BYTES) {
      into.putLong(at + Long.BYTES, second);
      if (length > 2 * Long.BYTES) {
        putRest(into, at);
      }
    }
  }

  private void putRest(ByteBuffer into, int at) {
    for (int i = 2; i < words.length; i++) {
      into.putLong(at + i * Long.BYTES, words[i]);
    }
  }

  /** The first eight bytes, big-endian, filled up with zeros. */
  long beginning() {
    return first;
  }

  /** The bits of {@link #beginning} that are the name's. */
  long mask() {
    return firstMask;
  }

  /** Whether the name stands there, of which the beginning is known to. */
  boolean isAt(ByteBuffer input, int at) {
    int left = input.limit() - at;
    if (left < length) {
      return false;
    }
    if (length <= Long.BYTES) {
      return true;
    }
    if (left < 2 * Long.BYTES) {
      return isRestAt(input, at, Long.BYTES);
    }
    return (input.getLong(at + Long.BYTES) & secondMask) == second
        && (length <= 2 * Long.BYTES || isRestAt(input, at, 2 * Long.BYTES));
  }

  private boolean isRestAt(ByteBuffer input, int at, int from) {
    for (int i = from; i < length; i++) {
      if (input.get(at + i) != bytes[i]) {
        return false;
      }
    }
    return true;
  }
}
