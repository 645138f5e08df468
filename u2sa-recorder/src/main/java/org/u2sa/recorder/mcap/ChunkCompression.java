package org.u2sa.recorder.mcap;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.zip.CRC32;
import net.jpountz.lz4.LZ4Exception;
import net.jpountz.lz4.LZ4Factory;
import net.jpountz.lz4.LZ4FrameInputStream;
import net.jpountz.xxhash.XXHashFactory;
import org.u2sa.recorder.mcap.record.McapException;
import org.u2sa.recorder.mcap.record.RecordBuffer;

/** Compression of chunks. Pure Java, so that output is byte-identical on every platform. */
public enum ChunkCompression {
  NONE("") {
    @Override
    void compress(byte[] bytes, int length, RecordBuffer out) {
      out.bytes(bytes, 0, length);
    }

    @Override
    byte[] plainly(byte[] compressed, long length) {
      return compressed.length == length ? compressed : null;
    }

    @Override
    InputStream decompressing(byte[] compressed) {
      return new ByteArrayInputStream(compressed);
    }
  },

  /** LZ4 frames of independent blocks: all intact blocks of a damaged frame remain readable. */
  LZ4("lz4") {
    @Override
    void compress(byte[] bytes, int length, RecordBuffer out) {
      out.fill(Lz4Frame.longest(length), (to, at) -> Lz4Frame.write(bytes, length, to, at));
    }

    @Override
    byte[] plainly(byte[] compressed, long length) {
      return Lz4Frame.read(compressed, length);
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
  private static final String ZSTD = "zstd"; // its decoders are native code or need Unsafe

  private final String inFile;

  ChunkCompression(String inFile) {
    this.inFile = inFile;
  }

  /** Name in a chunk's header. */
  String inFile() {
    return inFile;
  }

  abstract void compress(byte[] bytes, int length, RecordBuffer out);

  /** Fast path for frames in the usual format; null for other formats or on error. */
  byte[] plainly(byte[] compressed, long length) {
    return null;
  }

  abstract InputStream decompressing(byte[] compressed) throws IOException;

  static ChunkCompression of(String inFile) throws IOException {
    for (ChunkCompression compression : values()) {
      if (compression.inFile.equals(inFile)) {
        return compression;
      }
    }
    if (inFile.equals(ZSTD)) {
      throw new UnsupportedCompressionException(ZSTD);
    }
    throw new McapException(
        "a chunk is compressed with \"" + inFile + "\"; expected lz4 or no compression");
  }

  /** Decompresses the records of a chunk; their CRC is 0 if unknown. */
  byte[] decompress(byte[] compressed, long length, long expectedCrc) throws McapException {
    byte[] bytes = plainly(compressed, length);
    if (bytes == null) {
      Prefix prefix = decompressPrefix(compressed, length);
      bytes = prefix.bytes;
      if (prefix.trouble != null || bytes.length != length) {
        throw new McapException(
            "a chunk holds " + bytes.length + " of its " + length + " bytes", prefix.trouble);
      }
    }
    CRC32 crc = new CRC32();
    crc.update(bytes);
    if (expectedCrc != 0 && expectedCrc != crc.getValue()) {
      throw new McapException("a chunk is damaged: its checksum is wrong");
    }
    return bytes;
  }

  /** The bytes up to the first error, or all; the error is null if none. */
  record Prefix(byte[] bytes, IOException trouble) {}

  /** Decompresses as much as possible of a possibly truncated chunk, up to a limit. */
  Prefix decompressPrefix(byte[] compressed, long atMost) {
    byte[] whole = plainly(compressed, atMost); // also of formats that the stream below lacks
    if (whole != null) {
      return new Prefix(whole, null);
    }
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
    } catch (LZ4Exception e) { // damaged bytes within a block
      return new Prefix(
          out.toByteArray(), new McapException("damaged LZ4 block: " + e.getMessage(), e));
    }
  }
}
