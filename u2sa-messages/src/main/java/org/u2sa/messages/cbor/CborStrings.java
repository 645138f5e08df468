package org.u2sa.messages.cbor;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** Reads texts and byte strings of definite or indefinite length. */
final class CborStrings {
  private CborStrings() {}

  static String text(CborInput in) {
    if ((in.next() & Cbor.MAJOR) != Cbor.TEXT) {
      throw in.unexpected("text");
    }
    if (!in.takeIndefinite()) {
      return textPiece(in, Limits.TEXT_BYTES);
    }
    StringBuilder whole = new StringBuilder();
    int left = Limits.TEXT_BYTES;
    while (!in.isBreak()) {
      requirePiece(in, Cbor.TEXT, "a piece of text or its end");
      int before = in.offset();
      whole.append(textPiece(in, left));
      left -= in.offset() - before - 1;
    }
    return whole.toString();
  }

  private static String textPiece(CborInput in, int atMost) {
    int start = piece(in, atMost, "expected at most " + Limits.TEXT_BYTES + " bytes of text");
    byte[] bytes = in.bytes();
    int length = in.offset() - start;
    for (int i = start; i < start + length; i++) {
      if (bytes[i] < 0) {
        return utf8(bytes, start, length);
      }
    }
    return new String(bytes, start, length, StandardCharsets.ISO_8859_1); // identical for ASCII
  }

  private static String utf8(byte[] bytes, int start, int length) {
    try {
      CharBuffer text =
          StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes, start, length));
      return text.toString();
    } catch (CharacterCodingException e) {
      throw new IllegalArgumentException(
          "expected text in UTF-8; an unpaired surrogate is invalid", e);
    }
  }

  static ByteString byteString(CborInput in) {
    if ((in.next() & Cbor.MAJOR) != Cbor.BYTES) {
      throw in.unexpected("a byte string");
    }
    if (!in.takeIndefinite()) {
      return ByteString.owning(bytesPiece(in, Limits.BYTE_STRING_BYTES));
    }
    ByteArrayOutputStream whole = new ByteArrayOutputStream();
    while (!in.isBreak()) {
      requireBytesPiece(in);
      byte[] piece = bytesPiece(in, Limits.BYTE_STRING_BYTES - whole.size());
      whole.write(piece, 0, piece.length);
    }
    return ByteString.owning(whole.toByteArray());
  }

  private static byte[] bytesPiece(CborInput in, int atMost) {
    int start =
        piece(
            in, atMost, "expected at most " + Limits.BYTE_STRING_BYTES + " bytes in a byte string");
    return Arrays.copyOfRange(in.bytes(), start, in.offset());
  }

  /** Reads a byte string bounded by the message size, without copying if its length is definite. */
  static ByteBuffer bytesInPlace(CborInput in) {
    if ((in.next() & Cbor.MAJOR) != Cbor.BYTES || isIndefinite(in)) {
      return ByteBuffer.wrap(byteString(in).shared());
    }
    int start = wholePiece(in);
    return ByteBuffer.wrap(in.bytes(), start, in.offset() - start);
  }

  static void skipBytes(CborInput in) {
    if (!in.takeIndefinite()) {
      wholePiece(in);
      return;
    }
    while (!in.isBreak()) {
      requireBytesPiece(in);
      wholePiece(in);
    }
  }

  /** Skips a chunk of any length; returns its start. */
  private static int wholePiece(CborInput in) {
    long length = in.argument();
    if (length < 0 || length > in.left()) {
      throw new IllegalArgumentException("expected a byte string that fits into the message");
    }
    return in.skipBytes((int) length);
  }

  /** Skips a chunk of bounded length; returns its start. */
  private static int piece(CborInput in, int atMost, String expected) {
    long length = in.argument();
    if (length < 0 || length > atMost) {
      throw new IllegalArgumentException(expected);
    }
    return in.skipBytes((int) length);
  }

  private static void requireBytesPiece(CborInput in) {
    requirePiece(in, Cbor.BYTES, "a piece of a byte string or its end");
  }

  private static void requirePiece(CborInput in, int major, String what) {
    if ((in.bytes()[in.offset()] & Cbor.MAJOR) != major || isIndefinite(in)) {
      throw in.unexpected(what);
    }
  }

  private static boolean isIndefinite(CborInput in) {
    return (in.bytes()[in.offset()] & Cbor.INFO) == Cbor.INDEFINITE;
  }
}
