package org.u2sa.messages.schema;

import java.nio.ByteBuffer;
import java.util.Arrays;

/** What names a field on the wire, made once and written eight bytes at a time. Immutable. */
final class FieldKey {
  private final byte[] bytes;
  private final int length;
  private final long[] words; // the bytes, big-endian; the last word is filled up with zeros
  private final long first; // of them: most names are that short
  private final long second; // 0 if there is none
  private final long firstMask; // which bits of the first word are the key's

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

  /** So many words, big-endian, of bytes that are filled up with zeros. */
  static long[] words(byte[] bytes, int count) {
    ByteBuffer view = ByteBuffer.wrap(Arrays.copyOf(bytes, count * Long.BYTES));
    long[] words = new long[count];
    for (int i = 0; i < count; i++) {
      words[i] = view.getLong(i * Long.BYTES);
    }
    return words;
  }

  /** The bits of a word that are those of its first so many bytes; all of them, if it has fewer. */
  static long mask(int count) {
    int kept = Math.max(0, Math.min(Long.BYTES, count));
    return kept == 0 ? 0L : -1L << (Long.BYTES - kept) * Byte.SIZE;
  }

  /** The key as a CBOR data item; nobody changes it. */
  byte[] bytes() {
    return bytes;
  }

  /** Whether a key begins that opens with those eight bytes, big-endian. */
  boolean opens(long word) {
    return (word & firstMask) == first;
  }

  int length() {
    return length;
  }

  /** How many bytes {@link #put} touches. */
  int room() {
    return words.length * Long.BYTES;
  }

  /** Writes the key; what follows it within {@link #room()} is overwritten by zeros. */
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
