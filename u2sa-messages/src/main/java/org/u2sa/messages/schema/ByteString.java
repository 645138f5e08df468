package org.u2sa.messages.schema;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Base64;

/** Bytes that never change, such as an encoded picture. Two are equal if their bytes are. */
public final class ByteString {
  private final byte[] bytes;

  private ByteString(byte[] bytes) {
    this.bytes = bytes;
  }

  /** A copy of these bytes. */
  public static ByteString copyOf(byte[] bytes) {
    return new ByteString(bytes.clone());
  }

  /** These bytes; nobody else changes the array any more. */
  static ByteString owning(byte[] bytes) {
    return new ByteString(bytes);
  }

  /**
   * The bytes that a text of base64 (RFC 4648, 4) stands for; blanks and line ends in it are
   * skipped.
   *
   * @throws IllegalArgumentException if it is no base64
   */
  public static ByteString ofBase64(String text) {
    try {
      return new ByteString(Base64.getDecoder().decode(text.replaceAll("\\s+", "")));
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException("expected bytes in base64", e);
    }
  }

  /** The bytes in base64 with padding (RFC 4648, 4), on one line. */
  public String toBase64() {
    return Base64.getEncoder().encodeToString(bytes);
  }

  /** How many bytes there are. */
  public int length() {
    return bytes.length;
  }

  /** A copy of the bytes. */
  public byte[] toBytes() {
    return bytes.clone();
  }

  /** The bytes without a copy, read-only; each call has a position of its own. */
  public ByteBuffer view() {
    return ByteBuffer.wrap(bytes).asReadOnlyBuffer();
  }

  /** The bytes themselves, for who only reads them. */
  byte[] shared() {
    return bytes;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof ByteString && Arrays.equals(bytes, ((ByteString) other).bytes);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(bytes);
  }

  /** "1024 bytes": how many there are, not which. */
  @Override
  public String toString() {
    return bytes.length == 1 ? "1 byte" : bytes.length + " bytes";
  }
}
