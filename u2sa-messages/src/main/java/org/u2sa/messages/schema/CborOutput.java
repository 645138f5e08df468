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

  private byte[] bytes = new byte[TYPICAL_BYTES];
  private ByteBuffer view = ByteBuffer.wrap(bytes);
  private int length;

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
    byte[] utf8 = value.getBytes(StandardCharsets.UTF_8);
    head(Cbor.TEXT, utf8.length);
    item(utf8);
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

  /** What was encoded before, such as a field's name. */
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
