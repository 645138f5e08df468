package org.u2sa.messages.cbor;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/**
 * Cache of recently read short texts. Messages repeat the names of systems, services and frames,
 * and a cache hit is faster than creating a string and leaves no garbage.
 *
 * <p>Thread-safe: entries are immutable, and one not yet visible to another thread is merely
 * created twice.
 */
public final class RecentTexts {
  /** Maximum length of a cached text. */
  static final int LONGEST = 3 * Long.BYTES - 1;

  private static final int INDEX_BITS = 8;
  private static final long SIGNS = 0x8080_8080_8080_8080L; // sign bits, set in non-ASCII bytes
  private static final long GOLDEN_RATIO = 0x9E37_79B9_7F4A_7C15L; // spreads hash values

  private final Entry[] entries = new Entry[1 << INDEX_BITS];

  /** A text and its bytes as zero-padded big-endian words. */
  private record Entry(long first, long second, long third, int length, String text) {}

  /** Text of at most {@link #LONGEST} bytes; null if not ASCII. */
  String text(byte[] bytes, int start, int length) {
    long first = word(bytes, start, length);
    long second = length > Long.BYTES ? word(bytes, start + Long.BYTES, length - Long.BYTES) : 0L;
    long third =
        length > 2 * Long.BYTES ? word(bytes, start + 2 * Long.BYTES, length - 2 * Long.BYTES) : 0L;
    int index =
        (int) (((first * 31 + second) * 31 + third) * GOLDEN_RATIO >>> Long.SIZE - INDEX_BITS);
    Entry entry = entries[index];
    if (entry != null
        && entry.first == first
        && entry.second == second
        && entry.third == third
        && entry.length == length) { // a text may end in NUL
      return entry.text;
    }
    if (((first | second | third) & SIGNS) != 0L) {
      return null;
    }
    String text = new String(bytes, start, length, StandardCharsets.ISO_8859_1); // as ASCII
    entries[index] = new Entry(first, second, third, length, text);
    return text;
  }

  /** The first eight bytes, zero-padded. */
  private static long word(byte[] bytes, int start, int length) {
    if (bytes.length - start >= Long.BYTES) {
      return ByteBuffer.wrap(bytes).getLong(start) & FieldKey.mask(length);
    }
    long word = 0L;
    for (int i = 0; i < length; i++) {
      word |= (bytes[start + i] & 0xFFL) << Long.SIZE - Byte.SIZE * (i + 1);
    }
    return word;
  }
}
