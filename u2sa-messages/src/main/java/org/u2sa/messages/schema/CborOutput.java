package org.u2sa.messages.schema;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * Bytes of CBOR data items (RFC 8949), one after the other: definite lengths, shortest integers,
 * float64.
 */
final class CborOutput {
  private static final int TYPICAL_BYTES = 512;
  private static final int LONGEST_HEAD = 9;
  private static final int SHORT_TEXT = 64; // chars, up to which copying them one by one is fastest
  private static final int ASCII_LAST = 0x7F;

  private byte[] bytes;
  private ByteBuffer view;
  private int length;

  CborOutput() {
    this(TYPICAL_BYTES);
  }

  /**
   * @param expected bytes, about; takes more as well
   */
  CborOutput(int expected) {
    bytes = new byte[expected];
    view = ByteBuffer.wrap(bytes);
  }

  /** All that was written. */
  byte[] toBytes() {
    return Arrays.copyOf(bytes, length);
  }

  void number(double value) {
    reserve(LONGEST_HEAD);
    bytes[length] = (byte) Cbor.FLOAT_64;
    view.putDouble(length + 1, value);
    length += LONGEST_HEAD;
  }

  /**
   * Names and values of numbers.
   *
   * @param fields by slot
   * @param slots which to write, a bit each
   * @param bound writes those of slots below it
   * @return which are left, a bit each
   */
  long numbers(NumberField<?>[] fields, FieldStorage storage, long slots, int bound) {
    long left = slots;
    int at = length; // fields of this object would be read and written each time
    for (int slot = Long.numberOfTrailingZeros(left);
        slot < bound;
        slot = Long.numberOfTrailingZeros(left)) {
      left &= left - 1;
      NumberField<?> field = fields[slot];
      FieldKey key = field.key;
      if (at + key.room() + LONGEST_HEAD > bytes.length) {
        length = at;
        reserve(key.room() + LONGEST_HEAD);
      }
      ByteBuffer into = view;
      key.put(into, at);
      at += key.length();
      into.put(at, (byte) Cbor.FLOAT_64);
      into.putDouble(at + 1, storage.get(field));
      at += LONGEST_HEAD;
    }
    length = at;
    return left;
  }

  /** An array of numbers. */
  void numbers(Numbers values) {
    int size = values.size();
    head(Cbor.ARRAY, size);
    reserve(size * LONGEST_HEAD);
    ByteBuffer into = view;
    int at = length;
    for (int i = 0; i < size; i++) {
      into.put(at, (byte) Cbor.FLOAT_64);
      into.putDouble(at + 1, values.at(i));
      at += LONGEST_HEAD;
    }
    length = at;
  }

  /** An array of true and false. */
  void flags(Flags values) {
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

  void count(long value) {
    if (value < 0) {
      head(Cbor.NEGATIVE, ~value);
    } else {
      head(Cbor.UNSIGNED, value);
    }
  }

  void flag(boolean value) {
    reserve(1);
    bytes[length++] = (byte) (value ? Cbor.TRUE : Cbor.FALSE);
  }

  void text(String value) {
    int chars = value.length();
    if (chars > SHORT_TEXT || !ascii(value, chars)) {
      byte[] utf8 = value.getBytes(StandardCharsets.UTF_8);
      head(Cbor.TEXT, utf8.length);
      item(utf8);
    }
  }

  /** Writes a short text if it is of ASCII; otherwise nothing counts as written. */
  private boolean ascii(String value, int chars) {
    int before = length;
    head(Cbor.TEXT, chars);
    reserve(chars);
    for (int i = 0; i < chars; i++) {
      char each = value.charAt(i);
      if (each > ASCII_LAST) {
        length = before;
        return false;
      }
      bytes[length + i] = (byte) each;
    }
    length += chars;
    return true;
  }

  void byteString(ByteString value) {
    head(Cbor.BYTES, value.length());
    item(value.shared());
  }

  /** What opens an array; its elements are to follow. */
  void array(int elements) {
    head(Cbor.ARRAY, elements);
  }

  /** What opens a map; its pairs are to follow. */
  void map(int pairs) {
    head(Cbor.MAP, pairs);
  }

  /** A field's name. */
  void key(FieldKey key) {
    reserve(key.room());
    key.put(view, length);
    length += key.length();
  }

  /** What was encoded before. */
  void item(byte[] encoded) {
    reserve(encoded.length);
    System.arraycopy(encoded, 0, bytes, length, encoded.length);
    length += encoded.length;
  }

  private void head(int major, long argument) {
    reserve(LONGEST_HEAD);
    if (argument < Cbor.ONE_BYTE) {
      bytes[length++] = (byte) (major | (int) argument);
    } else if (argument <= 0xFF) {
      bytes[length++] = (byte) (major | Cbor.ONE_BYTE);
      bytes[length++] = (byte) argument;
    } else if (argument <= 0xFFFF) {
      bytes[length] = (byte) (major | Cbor.TWO_BYTES);
      view.putShort(length + 1, (short) argument);
      length += 1 + Short.BYTES;
    } else if (argument <= 0xFFFF_FFFFL) {
      bytes[length] = (byte) (major | Cbor.FOUR_BYTES);
      view.putInt(length + 1, (int) argument);
      length += 1 + Integer.BYTES;
    } else {
      bytes[length] = (byte) (major | Cbor.EIGHT_BYTES);
      view.putLong(length + 1, argument);
      length += LONGEST_HEAD;
    }
  }

  private void reserve(int more) {
    if (length + more > bytes.length) {
      bytes = Arrays.copyOf(bytes, Math.max(2 * bytes.length, length + more));
      view = ByteBuffer.wrap(bytes);
    }
  }
}
