package org.u2sa.messages.cbor;

import java.nio.ByteBuffer;

/**
 * Reads consecutive CBOR data items (RFC 8949) from untrusted bytes. Tags are skipped. Allocates no
 * more memory than the input's size; malformed input causes an {@link IllegalArgumentException}
 * naming what was expected.
 */
public final class CborInput {
  /** Returned by {@link #array} and {@link #map} for indefinite lengths. */
  public static final long UNTIL_BREAK = -1;

  private static final int HALF_EXPONENT = 10; // fraction bits below the exponent
  private static final int HALF_FRACTION = 0x3FF;
  private static final int HALF_LARGEST_EXPONENT = 0x1F;

  private final byte[] bytes;
  private final RecentTexts recent;
  private int at;

  /** Reads from the start of these bytes. */
  public CborInput(byte[] bytes) {
    this(bytes, new RecentTexts());
  }

  /**
   * @param recent cache of texts likely to recur
   */
  public CborInput(byte[] bytes, RecentTexts recent) {
    this.bytes = bytes;
    this.recent = recent;
  }

  /** Bytes read so far. */
  public int offset() {
    return at;
  }

  int left() {
    return bytes.length - at;
  }

  /**
   * All bytes, for callers that read several items at once and then call {@link #passTo}; not to be
   * modified.
   */
  public byte[] bytes() {
    return bytes;
  }

  /** Continues at an offset. */
  public void passTo(int offset) {
    at = offset;
  }

  /** Whether everything is read. */
  public boolean isAtEnd() {
    return at == bytes.length;
  }

  /** Peeks at the first byte of the next item, skipping tags. */
  public int next() {
    while (at < bytes.length && (bytes[at] & Cbor.MAJOR) == Cbor.TAG) {
      argument();
    }
    if (at == bytes.length) {
      throw new IllegalArgumentException("expected a data item, not the end");
    }
    return bytes[at] & 0xFF;
  }

  /** Reads the next tag's number; -1 if none follows. */
  public long tag() {
    boolean isTag = at < bytes.length && (bytes[at] & Cbor.MAJOR) == Cbor.TAG;
    return isTag ? argument() : -1L;
  }

  /** Peeks whether the next item is an unsigned integer, as labels are. */
  public boolean isLabelNext() {
    return at < bytes.length && (bytes[at] & Cbor.MAJOR) == Cbor.UNSIGNED;
  }

  /** Peeks at the next eight bytes, big-endian, zero-padded at the end. */
  public long word() {
    return bytes.length - at >= Long.BYTES ? view().getLong(at) : lastWord();
  }

  private long lastWord() {
    long word = 0L;
    for (int i = 0; i < Long.BYTES; i++) {
      word = word << Byte.SIZE | (at + i < bytes.length ? bytes[at + i] & 0xFF : 0);
    }
    return word;
  }

  /** Consumes the key if it is next. */
  public boolean take(FieldKey key) {
    boolean isNext = isNext(key);
    if (isNext) {
      at += key.length();
    }
    return isNext;
  }

  /** Peeks whether the key is next in its shortest form. */
  public boolean isNext(FieldKey key) {
    return key.length() <= bytes.length - at
        && key.opens(word())
        && (key.length() <= Long.BYTES || isRestNext(key.bytes()));
  }

  private boolean isRestNext(byte[] encoded) {
    for (int i = Long.BYTES; i < encoded.length; i++) {
      if (bytes[at + i] != encoded[i]) {
        return false;
      }
    }
    return true;
  }

  /** New buffer per call: escape analysis removes it. */
  private ByteBuffer view() {
    return ByteBuffer.wrap(bytes);
  }

  /** Reads a number of any width, including integers. */
  public double number() {
    int first = next();
    if (first == Cbor.FLOAT_64) {
      int start = skipBytes(1 + Double.BYTES) + 1;
      return view().getDouble(start);
    }
    if (first == Cbor.FLOAT_32) {
      int start = skipBytes(1 + Float.BYTES) + 1;
      return view().getFloat(start);
    }
    if (first == Cbor.FLOAT_16) {
      int start = skipBytes(1 + Short.BYTES) + 1;
      return half(view().getShort(start));
    }
    if ((first & Cbor.MAJOR) > Cbor.NEGATIVE) {
      throw unexpected("a number");
    }
    long argument = argument();
    double size = argument >= 0 ? argument : (argument >>> 1) * 2.0 + (argument & 1);
    return (first & Cbor.MAJOR) == Cbor.UNSIGNED ? size : -1.0 - size;
  }

  /** Fills the array with numbers. */
  public void numbers(double[] into) {
    ByteBuffer view = view();
    for (int i = 0; i < into.length; i++) {
      if (bytes.length - at > Double.BYTES && (bytes[at] & 0xFF) == Cbor.FLOAT_64) {
        into[i] = view.getDouble(at + 1);
        at += 1 + Double.BYTES;
      } else {
        into[i] = number();
      }
    }
  }

  /** Fills the array with flags. */
  public void flags(boolean[] into) {
    for (int i = 0; i < into.length; i++) {
      if (at < bytes.length && (bytes[at] | 1) == (byte) Cbor.TRUE) {
        into[i] = bytes[at++] == (byte) Cbor.TRUE;
      } else {
        into[i] = flag(); // tagged, or not a flag
      }
    }
  }

  /** RFC 8949, appendix D. */
  static double half(short bits) {
    int exponent = bits >> HALF_EXPONENT & HALF_LARGEST_EXPONENT;
    int fraction = bits & HALF_FRACTION;
    double size;
    if (exponent == 0) {
      size = Math.scalb((double) fraction, -24);
    } else if (exponent < HALF_LARGEST_EXPONENT) {
      size = Math.scalb((double) (fraction + HALF_FRACTION + 1), exponent - 25);
    } else {
      size = fraction == 0 ? Double.POSITIVE_INFINITY : Double.NaN;
    }
    return bits < 0 ? -size : size;
  }

  /**
   * Reads a 64-bit integer.
   *
   * @throws IllegalArgumentException if the next item has another type
   */
  public long count() {
    int left = bytes.length - at;
    if (left > Long.BYTES && bytes[at] == Cbor.EIGHT_BYTES && bytes[at + 1] >= 0) {
      at += 1 + Long.BYTES; // fast path for timestamps: microseconds since 1970
      return view().getLong(at - Long.BYTES);
    }
    return anyCount();
  }

  private long anyCount() {
    int major = next() & Cbor.MAJOR;
    if (major > Cbor.NEGATIVE) {
      throw unexpected("a 64-bit integer");
    }
    long argument = argument();
    if (argument < 0) {
      throw new IllegalArgumentException("expected a 64-bit integer, not a 65-bit one");
    }
    return major == Cbor.UNSIGNED ? argument : ~argument;
  }

  /**
   * Reads true or false.
   *
   * @throws IllegalArgumentException if the next item is neither
   */
  public boolean flag() {
    int first = next();
    if (first != Cbor.TRUE && first != Cbor.FALSE) {
      throw unexpected("true or false");
    }
    at++;
    return first == Cbor.TRUE;
  }

  /**
   * Reads a text.
   *
   * @throws IllegalArgumentException if the next item has another type, is too long or not UTF-8
   */
  public String text() {
    String text = shortText();
    return text == null ? CborStrings.text(this) : text;
  }

  /**
   * Fast path for short ASCII text with its length in the first byte; null, consuming nothing, for
   * any other.
   */
  private String shortText() {
    int length = at < bytes.length ? (bytes[at] & 0xFF) - Cbor.TEXT : -1;
    if (length < 0 || length > RecentTexts.LONGEST || length >= bytes.length - at) {
      return null;
    }
    String text = recent.text(bytes, at + 1, length);
    if (text != null) {
      at += 1 + length;
    }
    return text;
  }

  /** Reads a byte string of definite or indefinite length. */
  public ByteString byteString() {
    return CborStrings.byteString(this);
  }

  /** Opens an array; returns the number of elements, or {@link #UNTIL_BREAK}. */
  public long array() {
    return open(Cbor.ARRAY, "an array");
  }

  /** Opens a map; returns the number of pairs, or {@link #UNTIL_BREAK}. */
  public long map() {
    return open(Cbor.MAP, "a map");
  }

  private long open(int major, String what) {
    if ((next() & Cbor.MAJOR) != major) {
      throw unexpected(what);
    }
    if (takeIndefinite()) {
      return UNTIL_BREAK;
    }
    long length = argument();
    if (length < 0 || length > bytes.length - at) { // at least one byte each
      throw new IllegalArgumentException("expected " + what + " that fits into the message");
    }
    return length;
  }

  /** Consumes the first byte of an indefinite-length item if one is next. */
  boolean takeIndefinite() {
    boolean isIndefinite = (bytes[at] & Cbor.INFO) == Cbor.INDEFINITE;
    if (isIndefinite) {
      at++;
    }
    return isIndefinite;
  }

  /** Whether an array or map ends after this many elements; consumes a break. */
  public boolean isDone(long length, long read) {
    return length == UNTIL_BREAK ? isBreak() : read == length;
  }

  /** Consumes a break if it is next. */
  boolean isBreak() {
    if (at == bytes.length) {
      throw new IllegalArgumentException("expected a data item or a break, not the end");
    }
    if ((bytes[at] & 0xFF) != Cbor.BREAK) {
      return false;
    }
    at++;
    return true;
  }

  /**
   * Skips an item of any type.
   *
   * @param levels maximum nesting depth of arrays and maps in it
   */
  public void skip(int levels) {
    int first = next();
    switch (first & Cbor.MAJOR) {
      case Cbor.TEXT -> text();
      case Cbor.BYTES -> CborStrings.skipBytes(this);
      case Cbor.ARRAY -> skipItems(array(), 1, levels);
      case Cbor.MAP -> skipItems(map(), 2, levels);
      default -> {
        if (first == Cbor.BREAK) {
          throw new IllegalArgumentException("expected a data item, not a break");
        }
        argument();
      }
    }
  }

  private void skipItems(long length, int each, int levels) {
    if (levels == 0) {
      throw new IllegalArgumentException("expected at most " + Limits.DEPTH + " levels of nesting");
    }
    for (long read = 0; !isDone(length, read); read++) {
      for (int item = 0; item < each; item++) {
        skip(levels - 1);
      }
    }
  }

  /** Reads the first byte of an item and its unsigned argument. */
  long argument() {
    int info = bytes[at] & Cbor.INFO;
    if (info < Cbor.ONE_BYTE) {
      at++;
      return info;
    }
    return switch (info) {
      case Cbor.ONE_BYTE -> bytes[skipBytes(1 + Byte.BYTES) + 1] & 0xFF;
      case Cbor.TWO_BYTES -> view().getShort(skipBytes(1 + Short.BYTES) + 1) & 0xFFFF;
      case Cbor.FOUR_BYTES -> view().getInt(skipBytes(1 + Integer.BYTES) + 1) & 0xFFFF_FFFFL;
      case Cbor.EIGHT_BYTES -> view().getLong(skipBytes(1 + Long.BYTES) + 1);
      default -> {
        at++;
        throw new IllegalArgumentException(
            "expected a length or a value, not a reserved CBOR code");
      }
    };
  }

  /** Skips this many bytes; returns their start. */
  int skipBytes(int count) {
    if (count > bytes.length - at) {
      at = bytes.length;
      throw new IllegalArgumentException("expected more bytes, not the end");
    }
    int start = at;
    at += count;
    return start;
  }

  /** Skips the first byte of an unexpected item and throws. */
  public IllegalArgumentException unexpected(String what) {
    int first = bytes[at++] & 0xFF;
    return new IllegalArgumentException("expected " + what + ", not " + name(first));
  }

  private static String name(int first) {
    return switch (first & Cbor.MAJOR) {
      case Cbor.UNSIGNED, Cbor.NEGATIVE -> "an integer";
      case Cbor.BYTES -> "a byte string";
      case Cbor.TEXT -> "text";
      case Cbor.ARRAY -> "an array";
      case Cbor.MAP -> "a map";
      default ->
          switch (first) {
            case Cbor.TRUE, Cbor.FALSE -> "true or false";
            case Cbor.NULL -> "null";
            case Cbor.FLOAT_16, Cbor.FLOAT_32, Cbor.FLOAT_64 -> "a number with a fraction";
            case Cbor.BREAK -> "a break";
            default -> "a simple value";
          };
    };
  }
}
