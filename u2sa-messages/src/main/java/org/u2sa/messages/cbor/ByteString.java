package org.u2sa.messages.cbor;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Base64;

/** Immutable bytes, such as an encoded image, with value equality. */
public final class ByteString {
  private final byte[] bytes;

  private ByteString(byte[] bytes) {
    this.bytes = bytes;
  }

  /** Copies the bytes. */
  public static ByteString copyOf(byte[] bytes) {
    return new ByteString(bytes.clone());
  }

  /** Wraps the bytes; the caller must not modify the array afterwards. */
  static ByteString owning(byte[] bytes) {
    return new ByteString(bytes);
  }

  /**
   * Decodes base64 text (RFC 4648, 4), skipping whitespace.
   *
   * @throws IllegalArgumentException if it is not base64
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

  /** Number of bytes. */
  public int length() {
    return bytes.length;
  }

  /** A copy of the bytes. */
  public byte[] toBytes() {
    return bytes.clone();
  }

  /** Read-only view of the bytes; each call returns a buffer with its own position. */
  public ByteBuffer view() {
    return ByteBuffer.wrap(bytes).asReadOnlyBuffer();
  }

  /** The bytes themselves, which the caller must not modify. */
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

  /** "1024 bytes": the number of bytes, not their values. */
  @Override
  public String toString() {
    return bytes.length == 1 ? "1 byte" : bytes.length + " bytes";
  }
}
