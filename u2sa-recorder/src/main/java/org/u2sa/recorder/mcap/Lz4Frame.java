package org.u2sa.recorder.mcap;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import net.jpountz.lz4.LZ4Compressor;
import net.jpountz.lz4.LZ4Exception;
import net.jpountz.lz4.LZ4Factory;
import net.jpountz.lz4.LZ4SafeDecompressor;

/**
 * LZ4 frames of independent blocks of 64 KiB, without checksums, written and read from array to
 * array (lz4_Frame_format.md 1.6.4). The compressor is pure Java, so it runs on phones and output
 * is byte-identical on every platform.
 */
final class Lz4Frame {
  private static final byte[] HEADER = {0x04, 0x22, 0x4D, 0x18, 0x60, 0x40, (byte) 0x82};
  private static final int BLOCK = 1 << 16;
  private static final int AS_IT_IS = 1 << 31; // flag of an uncompressed block
  private static final LZ4Compressor COMPRESSOR = LZ4Factory.safeInstance().fastCompressor();
  private static final LZ4SafeDecompressor DECOMPRESSOR =
      LZ4Factory.safeInstance().safeDecompressor();
  private static final long MAX_TIMES = 255; // maximum compression ratio of LZ4

  private Lz4Frame() {}

  /** Maximum frame size for a content size. */
  static int longest(int length) {
    int blocks = (length + BLOCK - 1) / BLOCK;
    return HEADER.length
        + blocks * (Integer.BYTES + COMPRESSOR.maxCompressedLength(BLOCK))
        + Integer.BYTES;
  }

  /** Writes a frame into an array with room for {@link #longest}; returns the offset after it. */
  static int write(byte[] from, int length, byte[] to, int at) {
    ByteBuffer out = ByteBuffer.wrap(to).order(ByteOrder.LITTLE_ENDIAN);
    System.arraycopy(HEADER, 0, to, at, HEADER.length);
    int end = at + HEADER.length;
    for (int begin = 0; begin < length; begin += BLOCK) {
      int size = Math.min(BLOCK, length - begin);
      int data = end + Integer.BYTES;
      int compressed =
          COMPRESSOR.compress(from, begin, size, to, data, COMPRESSOR.maxCompressedLength(size));
      if (compressed < size) {
        out.putInt(end, compressed);
        end = data + compressed;
      } else {
        System.arraycopy(from, begin, to, data, size);
        out.putInt(end, size | AS_IT_IS);
        end = data + size;
      }
    }
    out.putInt(end, 0);
    return end + Integer.BYTES;
  }

  /**
   * Decodes a frame of {@link #write} or of linked blocks; null for others, another size, or
   * damage.
   */
  static byte[] read(byte[] frame, long size) {
    boolean isOurs =
        frame.length >= HEADER.length && Arrays.equals(Arrays.copyOf(frame, HEADER.length), HEADER);
    if (size < 0 || size > MAX_TIMES * frame.length) {
      return null;
    }
    if (!isOurs) {
      return LinkedLz4Frame.read(frame, (int) size);
    }
    ByteBuffer in = ByteBuffer.wrap(frame).order(ByteOrder.LITTLE_ENDIAN);
    byte[] to = new byte[(int) size];
    int filled = 0;
    int at = HEADER.length;
    while (frame.length - at >= Integer.BYTES) {
      int word = in.getInt(at);
      at += Integer.BYTES;
      int length = word & ~AS_IT_IS;
      if (word == 0) {
        return filled == to.length ? to : null;
      }
      if (length > frame.length - at) {
        return null;
      }
      if (word != length) {
        if (length > to.length - filled) {
          return null;
        }
        System.arraycopy(frame, at, to, filled, length);
        filled += length;
      } else {
        try {
          filled += DECOMPRESSOR.decompress(frame, at, length, to, filled, to.length - filled);
        } catch (LZ4Exception e) {
          return null; // damaged
        }
      }
      at += length;
    }
    return null;
  }
}
