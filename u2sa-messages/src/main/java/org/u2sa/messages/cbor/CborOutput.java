package org.u2sa.messages.cbor;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** Writes consecutive CBOR data items (RFC 8949): definite lengths, shortest integers, float64. */
public final class CborOutput {
  private static final int TYPICAL_BYTES = 512;
  private static final int LONGEST_HEAD = 9;
  private static final int ASCII_LAST = 0x7F;

  private final WireForm form;
  private byte[] bytes;
  private int length;

  /** Writes with readable keys. */
  public CborOutput() {
    this(WireForm.READABLE, TYPICAL_BYTES);
  }

  /**
   * @param form of the keys of all maps
   * @param expected approximate number of bytes; grows if exceeded
   */
  public CborOutput(WireForm form, int expected) {
    this.form = form;
    bytes = new byte[expected];
  }

  /** Form of the keys of all maps. */
  public WireForm form() {
    return form;
  }

  /** Bytes of an item's head with this unsigned argument. */
  private static int headBytes(long argument) {
    if (argument >>> Byte.SIZE == 0L) {
      return 1 + Byte.BYTES;
    }
    if (argument >>> Short.SIZE == 0L) {
      return 1 + Short.BYTES;
    }
    return argument >>> Integer.SIZE == 0L ? 1 + Integer.BYTES : LONGEST_HEAD;
  }

  /** Bytes written so far. */
  public int length() {
    return length;
  }

  /** Encoded numbers with their keys, all but the values. */
  public interface Pattern {
    /** Length [bytes]. */
    public int length();

    /**
     * Writes it; the caller ensures space.
     *
     * @param numbers the values, of which those of the pattern begin at {@code first}
     * @return end position
     */
    int put(byte[] into, int start, double[] numbers, int first);
  }

  /** Everything written; must be the last call. */
  public byte[] toBytes() {
    return length == bytes.length ? bytes : Arrays.copyOf(bytes, length);
  }

  /** Writes a number as float64. */
  public void number(double value) {
    reserve(LONGEST_HEAD);
    bytes[length] = (byte) Cbor.FLOAT_64;
    ByteBuffer.wrap(bytes).putDouble(length + 1, value);
    length += LONGEST_HEAD;
  }

  /**
   * Keys and values of those numbers.
   *
   * @param numbers the values, of which those of the pattern begin at {@code first}
   */
  public void numbers(Pattern pattern, double[] numbers, int first) {
    reserve(pattern.length());
    length = pattern.put(bytes, length, numbers, first);
  }

  /** An array of numbers. */
  public void numbers(Numbers values) {
    int size = values.size();
    head(Cbor.ARRAY, size);
    reserve(size * LONGEST_HEAD);
    length = values.put(bytes, length);
  }

  /** An array of true and false. */
  public void flags(Flags values) {
    int size = values.size();
    head(Cbor.ARRAY, size);
    reserve(size);
    byte[] into = bytes;
    int at = length;
    for (int i = 0; i < size; i++) {
      into[at + i] = (byte) (values.at(i) ? Cbor.TRUE : Cbor.FALSE);
    }
    length = at + size;
  }

  /** Writes an integer in as few bytes as possible. */
  public void count(long value) {
    if (value < 0) {
      head(Cbor.NEGATIVE, ~value);
    } else {
      head(Cbor.UNSIGNED, value);
    }
  }

  /** Writes true or false. */
  public void flag(boolean value) {
    reserve(1);
    bytes[length++] = (byte) (value ? Cbor.TRUE : Cbor.FALSE);
  }

  /** Writes a text in UTF-8. */
  public void text(String value) {
    if (!shortAscii(value)) {
      byte[] utf8 = value.getBytes(StandardCharsets.UTF_8);
      head(Cbor.TEXT, utf8.length);
      item(utf8);
    }
  }

  /** Fast path for ASCII text with its length in the first byte; false if not applicable. */
  private boolean shortAscii(String value) {
    int chars = value.length();
    if (chars >= Cbor.ONE_BYTE) {
      return false;
    }
    reserve(1 + chars);
    byte[] into = bytes;
    int at = length;
    into[at++] = (byte) (Cbor.TEXT | chars);
    int bits = 0;
    for (int i = 0; i < chars; i++) {
      char each = value.charAt(i);
      bits |= each;
      into[at + i] = (byte) each;
    }
    if (bits > ASCII_LAST) {
      return false;
    }
    length = at + chars;
    return true;
  }

  void tag(int number) {
    head(Cbor.TAG, number);
  }

  /** Opens a byte string of this length; returns a little-endian buffer for its content. */
  public ByteBuffer byteString(int size) {
    head(Cbor.BYTES, size);
    reserve(size);
    length += size;
    return ByteBuffer.wrap(bytes, length - size, size).order(ByteOrder.LITTLE_ENDIAN);
  }

  /** Writes a byte string. */
  public void byteString(ByteString value) {
    head(Cbor.BYTES, value.length());
    item(value.shared());
  }

  /** Opens an array; its elements must follow. */
  public void array(int elements) {
    head(Cbor.ARRAY, elements);
  }

  /** Opens a map; its pairs must follow. */
  public void map(int pairs) {
    head(Cbor.MAP, pairs);
  }

  /** A field's name or label. */
  public void key(FieldKey key) {
    if (bytes.length - length < key.room()) { // put() may write beyond the key
      item(key.bytes());
    } else {
      key.put(ByteBuffer.wrap(bytes), length);
      length += key.length();
    }
  }

  /** Appends encoded bytes. */
  public void item(byte[] encoded) {
    reserve(encoded.length);
    System.arraycopy(encoded, 0, bytes, length, encoded.length);
    length += encoded.length;
  }

  private void head(int major, long argument) {
    if (argument >= 0 && argument < Cbor.ONE_BYTE) {
      reserve(1);
      bytes[length++] = (byte) (major | (int) argument);
    } else {
      longHead(major, argument);
    }
  }

  private void longHead(int major, long argument) {
    int size = headBytes(argument);
    reserve(size);
    byte[] into = bytes;
    int at = length;
    length = at + size;
    ByteBuffer view = ByteBuffer.wrap(into);
    switch (size) {
      case 1 + Byte.BYTES -> {
        into[at] = (byte) (major | Cbor.ONE_BYTE);
        into[at + 1] = (byte) argument;
      }
      case 1 + Short.BYTES -> {
        into[at] = (byte) (major | Cbor.TWO_BYTES);
        view.putShort(at + 1, (short) argument);
      }
      case 1 + Integer.BYTES -> {
        into[at] = (byte) (major | Cbor.FOUR_BYTES);
        view.putInt(at + 1, (int) argument);
      }
      default -> {
        into[at] = (byte) (major | Cbor.EIGHT_BYTES);
        view.putLong(at + 1, argument);
      }
    }
  }

  private void reserve(int more) {
    if (length + more > bytes.length) {
      bytes = Arrays.copyOf(bytes, Math.max(2 * bytes.length, length + more));
    }
  }
}
