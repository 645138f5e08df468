package org.u2sa.recorder.mcap;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.Arrays;
import java.util.zip.CRC32;
import net.jpountz.lz4.LZ4Exception;
import net.jpountz.lz4.LZ4Factory;
import net.jpountz.lz4.LZ4FrameInputStream;
import net.jpountz.lz4.LZ4FrameOutputStream;
import net.jpountz.xxhash.XXHashFactory;

/**
 * How chunks are compressed. Both ways are pure Java, so that the bytes are everywhere the same.
 */
public enum ChunkCompression {
  /** Not at all. */
  NONE("") {
    @Override
    byte[] compress(byte[] bytes, int length) {
      return Arrays.copyOf(bytes, length);
    }

    @Override
    InputStream decompressing(byte[] compressed) {
      return new ByteArrayInputStream(compressed);
    }
  },

  /** LZ4 frames of independent blocks: of a broken one all whole blocks can be read. */
  LZ4("lz4") {
    @Override
    byte[] compress(byte[] bytes, int length) throws IOException {
      ByteArrayOutputStream compressed = new ByteArrayOutputStream(length / 2 + 64);
      try (OutputStream frame =
          new LZ4FrameOutputStream(
              compressed,
              LZ4FrameOutputStream.BLOCKSIZE.SIZE_64KB,
              -1L,
              LZ4Factory.safeInstance().fastCompressor(),
              XXHashFactory.safeInstance().hash32(),
              LZ4FrameOutputStream.FLG.Bits.BLOCK_INDEPENDENCE)) {
        frame.write(bytes, 0, length);
      }
      return compressed.toByteArray();
    }

    @Override
    InputStream decompressing(byte[] compressed) throws IOException {
      return new LZ4FrameInputStream(
          new ByteArrayInputStream(compressed),
          LZ4Factory.safeInstance().safeDecompressor(),
          XXHashFactory.safeInstance().hash32());
    }
  };

  private static final int PIECE = 1 << 16;

  private final String inFile;

  ChunkCompression(String inFile) {
    this.inFile = inFile;
  }

  /** What a chunk says of it. */
  String inFile() {
    return inFile;
  }

  abstract byte[] compress(byte[] bytes, int length) throws IOException;

  abstract InputStream decompressing(byte[] compressed) throws IOException;

  static ChunkCompression of(String inFile) throws McapException {
    for (ChunkCompression compression : values()) {
      if (compression.inFile.equals(inFile)) {
        return compression;
      }
    }
    throw new McapException(
        "a chunk is compressed with \"" + inFile + "\"; expected lz4 or no compression");
  }

  /**
   * The records of a chunk.
   *
   * @param expectedCrc of the records; 0: unknown
   */
  byte[] decompress(byte[] compressed, long length, long expectedCrc) throws McapException {
    Prefix prefix = decompressPrefix(compressed, length);
    if (prefix.trouble != null || prefix.bytes.length != length) {
      throw new McapException(
          "a chunk holds " + prefix.bytes.length + " of its " + length + " bytes", prefix.trouble);
    }
    CRC32 crc = new CRC32();
    crc.update(prefix.bytes);
    if (expectedCrc != 0 && expectedCrc != crc.getValue()) {
      throw new McapException("a chunk is damaged: its checksum is another");
    }
    return prefix.bytes;
  }

  /**
   * What can be decompressed.
   *
   * @param bytes up to where it goes wrong, or all
   * @param trouble what goes wrong; null: nothing
   */
  record Prefix(byte[] bytes, IOException trouble) {}

  /** As much as can be had of a chunk that may break off, and at most so many bytes. */
  Prefix decompressPrefix(byte[] compressed, long atMost) {
    ByteArrayOutputStream out =
        new ByteArrayOutputStream((int) Math.min(Math.max(atMost, 0), 16L << 20));
    byte[] piece = new byte[PIECE];
    try (InputStream in = decompressing(compressed)) {
      for (int n = in.read(piece); n >= 0 && out.size() < atMost; n = in.read(piece)) {
        out.write(piece, 0, (int) Math.min(n, atMost - out.size()));
      }
      return new Prefix(out.toByteArray(), null);
    } catch (IOException e) {
      return new Prefix(out.toByteArray(), e);
    } catch (LZ4Exception e) { // of damaged bytes within a block
      return new Prefix(out.toByteArray(), new McapException(e.toString(), e));
    }
  }
}
