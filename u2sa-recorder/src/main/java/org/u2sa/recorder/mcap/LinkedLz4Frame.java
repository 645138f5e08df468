package org.u2sa.recorder.mcap;

import java.nio.Buffer;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Reads LZ4 frames whose blocks refer to earlier ones, as the LZ4 library writes them by default
 * (lz4_Frame_format.md 1.6.4, lz4_Block_format.md); lz4-java reads independent blocks only.
 * Checksums are skipped: a chunk has its own.
 */
final class LinkedLz4Frame {
  private static final int MAGIC = 0x184D2204;
  private static final int VERSION = 0x40;
  private static final int VERSION_MASK = 0xC0;
  private static final int INDEPENDENT = 0x20;
  private static final int BLOCK_CHECKSUM = 0x10;
  private static final int CONTENT_SIZE = 0x08;
  private static final int DICTIONARY = 0x01;
  private static final int AS_IT_IS = 1 << 31; // flag of an uncompressed block
  private static final int MIN_MATCH = 4;
  private static final int NIBBLE = 15;
  private static final int BYTE = 255;

  private final ByteBuffer in;
  private final byte[] to;
  private int filled;

  private LinkedLz4Frame(byte[] frame, byte[] to) {
    in = ByteBuffer.wrap(frame).order(ByteOrder.LITTLE_ENDIAN);
    this.to = to;
  }

  /** Decodes a frame of linked blocks; null if it is another one, of another size, or damaged. */
  static byte[] read(byte[] frame, int size) {
    try {
      LinkedLz4Frame reader = new LinkedLz4Frame(frame, new byte[size]);
      return reader.isRead() && reader.filled == size ? reader.to : null;
    } catch (IndexOutOfBoundsException | IllegalArgumentException | BufferUnderflowException e) {
      return null; // damaged
    }
  }

  private boolean isRead() {
    if (in.getInt() != MAGIC) {
      return false;
    }
    int flags = in.get();
    if ((flags & VERSION_MASK) != VERSION || (flags & (INDEPENDENT | DICTIONARY)) != 0) {
      return false;
    }
    int skipped = 2 + ((flags & CONTENT_SIZE) != 0 ? Long.BYTES : 0); // block size, header checksum
    ((Buffer) in).position(in.position() + skipped);
    for (int word = in.getInt(); word != 0; word = in.getInt()) {
      int length = word & ~AS_IT_IS;
      int end = in.position() + length;
      if (word == length) {
        block(end);
      } else {
        literals(length);
      }
      ((Buffer) in).position(end + ((flags & BLOCK_CHECKSUM) != 0 ? Integer.BYTES : 0));
    }
    return true;
  }

  private void block(int end) {
    while (in.position() < end) {
      int token = in.get() & BYTE;
      literals(length(token >> 4));
      if (in.position() >= end) {
        return; // the last sequence has no match
      }
      int distance = in.getShort() & 0xFFFF;
      int length = length(token & NIBBLE) + MIN_MATCH;
      if (distance == 0) {
        throw new IllegalArgumentException("a match at distance 0");
      }
      for (int i = 0; i < length; i++, filled++) { // byte by byte: it may overlap itself
        to[filled] = to[filled - distance];
      }
    }
  }

  private int length(int nibble) {
    int length = nibble;
    if (nibble == NIBBLE) {
      int more;
      do {
        more = in.get() & BYTE;
        length += more;
      } while (more == BYTE);
    }
    return length;
  }

  private void literals(int length) {
    in.get(to, filled, length);
    filled += length;
  }
}
