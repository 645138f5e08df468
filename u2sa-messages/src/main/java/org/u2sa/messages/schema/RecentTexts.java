package org.u2sa.messages.schema;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/**
 * Short texts that were read lately. Messages repeat the names of systems, services and frames, so
 * reading one mostly finds it here, which is faster than making it anew and leaves no garbage.
 *
 * <p>Safe for all threads: entries are immutable, and one that another thread does not see yet is
 * only made twice.
 */
final class RecentTexts {
  /** Length of the longest text that is kept. */
  static final int LONGEST = 3 * Long.BYTES - 1;

  private static final int INDEX_BITS = 8;
  private static final long SIGNS = 0x8080_8080_8080_8080L; // set in bytes that are not ASCII
  private static final long GOLDEN_RATIO = 0x9E37_79B9_7F4A_7C15L; // spreads what is hashed

  private final Entry[] entries = new Entry[1 << INDEX_BITS];

  /** A text, and its bytes as big-endian words that are filled up with zeros. */
  private record Entry(long first, long second, long third, int length, String text) {}

  /**
   * The text in those bytes, of which there are at most {@link #LONGEST}; null if they are not all
   * ASCII.
   */
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

  /** The first eight of those bytes, or what there is of them and zeros. */
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
