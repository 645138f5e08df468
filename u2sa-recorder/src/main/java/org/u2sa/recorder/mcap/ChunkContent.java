package org.u2sa.recorder.mcap;

import java.io.IOException;
import java.util.zip.CRC32;
import org.u2sa.recorder.mcap.record.McapException;
import org.u2sa.recorder.mcap.record.RecordFields;

/**
 * Content of a chunk record in the file.
 *
 * @param size uncompressed size of its records [B]
 * @param crc CRC of its uncompressed records; 0 if unknown
 * @param compression compression of the records
 * @param compressed compressed records; incomplete if the file is truncated
 */
record ChunkContent(long size, long crc, ChunkCompression compression, byte[] compressed) {
  /** Records of a chunk up to the first error, and the error; null if none. */
  record Salvage(ChunkRecords records, IOException trouble) {}

  static ChunkContent read(RecordFields in) throws IOException {
    return read(in, false);
  }

  /** Reads the available part of a chunk. */
  static ChunkContent readBrokenOff(RecordFields in) throws IOException {
    return read(in, true);
  }

  private static ChunkContent read(RecordFields in, boolean brokenOff) throws IOException {
    in.uint64(); // first and last time; known from its messages
    in.uint64();
    long size = in.uint64();
    long crc = in.uint32();
    ChunkCompression compression = ChunkCompression.of(in.string());
    long length = in.uint64();
    if (size < 0 || size > ReadLimits.MAX_LENGTH) {
      throw new McapException("a chunk of " + size + " bytes: above the read limit");
    }
    return new ChunkContent(
        size, crc, compression, in.bytes(brokenOff ? Math.min(length, in.remaining()) : length));
  }

  /** Records with their offsets in the chunk. */
  ChunkRecords records() throws McapException {
    ChunkRecords records = new ChunkRecords(decompressed());
    McapException trouble = records.trouble();
    if (trouble != null) {
      throw new McapException("a chunk is damaged: " + trouble.getMessage(), trouble);
    }
    return records;
  }

  /** Bytes of its records, whose size must match the summary. */
  byte[] decompressed(long indexed) throws McapException {
    if (size != indexed) {
      throw new McapException("its header states " + size + " bytes, but the summary " + indexed);
    }
    return decompressed();
  }

  /** The bytes of its records. */
  byte[] decompressed() throws McapException {
    return compression.decompress(compressed, size, crc);
  }

  /** All complete records in the part that can be decompressed. */
  Salvage salvage() {
    ChunkCompression.Prefix prefix = compression.decompressPrefix(compressed, size);
    ChunkRecords records = new ChunkRecords(prefix.bytes());
    IOException trouble = prefix.trouble() != null ? prefix.trouble() : records.trouble();
    CRC32 actual = new CRC32();
    actual.update(prefix.bytes());
    if (trouble == null && crc != 0 && crc != actual.getValue()) {
      trouble = new McapException("a chunk's checksum is wrong: some of its bytes are damaged");
    }
    return new Salvage(records, trouble);
  }
}
