package org.u2sa.messages.cbor;

import java.nio.ByteBuffer;
import java.util.Arrays;

/** A field's key on the wire, encoded once and written eight bytes at a time. Immutable. */
public final class FieldKey {
  private final byte[] bytes;
  private final int length;
  private final long[] words; // the bytes, big-endian; the last word is zero-padded
  private final long first; // first word: most names fit into two
  private final long second; // 0 if none
  private final long firstMask; // bits of the first word used by the key

  private FieldKey(CborOutput encoded) {
    bytes = encoded.toBytes();
    length = bytes.length;
    words = words(bytes, (length + Long.BYTES - 1) / Long.BYTES);
    first = words[0];
    second = words.length > 1 ? words[1] : 0L;
    firstMask = mask(length);
  }

  static FieldKey ofName(String name) {
    CborOutput out = new CborOutput();
    out.text(name);
    return new FieldKey(out);
  }

  static FieldKey ofLabel(int label) {
    CborOutput out = new CborOutput();
    out.count(label);
    return new FieldKey(out);
  }

  /** Packs bytes into this many big-endian words, zero-padded. */
  static long[] words(byte[] bytes, int count) {
    ByteBuffer view = ByteBuffer.wrap(Arrays.copyOf(bytes, count * Long.BYTES));
    long[] words = new long[count];
    for (int i = 0; i < count; i++) {
      words[i] = view.getLong(i * Long.BYTES);
    }
    return words;
  }

  /** Mask of the first bytes of a word; all bits for eight or more. */
  public static long mask(int count) {
    int kept = Math.max(0, Math.min(Long.BYTES, count));
    return kept == 0 ? 0L : -1L << (Long.BYTES - kept) * Byte.SIZE;
  }

  /** The key as a CBOR data item; not to be modified. */
  public byte[] bytes() {
    return bytes;
  }

  /** Whether these eight bytes, big-endian, start with the key. */
  boolean opens(long word) {
    return (word & firstMask) == first;
  }

  /** Bytes of the key. */
  public int length() {
    return length;
  }

  /** Number of bytes written by {@link #put}, including padding. */
  int room() {
    return words.length * Long.BYTES;
  }

  /** Writes the key, zero-padded to {@link #room()}. */
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
}
