package org.u2sa.recorder.mcap;

import java.io.IOException;
import java.util.zip.CRC32;

/**
 * A chunk's record as it is in the file.
 *
 * @param size of its records [B]
 * @param crc of its records; 0: unknown
 * @param compression how they are compressed
 * @param compressed the records; perhaps not all of them, if the file breaks off
 */
record ChunkContent(long size, long crc, ChunkCompression compression, byte[] compressed) {
  /** Records up to where a chunk goes wrong, and why it does; null: it does not. */
  record Salvage(ChunkRecords records, IOException trouble) {}

  static ChunkContent read(RecordFields in) throws McapException {
    return read(in, false);
  }

  /** As much of a chunk as there is. */
  static ChunkContent readBrokenOff(RecordFields in) throws McapException {
    return read(in, true);
  }

  private static ChunkContent read(RecordFields in, boolean brokenOff) throws McapException {
    in.uint64(); // its first and last time, which its messages tell too
    in.uint64();
    long size = in.uint64();
    long crc = in.uint32();
    ChunkCompression compression = ChunkCompression.of(in.string());
    long length = in.uint64();
    if (size < 0 || size > ReadLimits.MAX_LENGTH) {
      throw new McapException("a chunk of " + size + " bytes: more than is read at once");
    }
    return new ChunkContent(
        size, crc, compression, in.bytes(brokenOff ? Math.min(length, in.remaining()) : length));
  }

  /** Its records, each with its offset in the chunk. */
  ChunkRecords records() throws McapException {
    ChunkRecords records = new ChunkRecords(decompressed());
    McapException trouble = records.trouble();
    if (trouble != null) {
      throw new McapException("a chunk is damaged: " + trouble.getMessage(), trouble);
    }
    return records;
  }

  /**
   * The bytes of its records.
   *
   * @param indexed how many the summary says there are
   */
  byte[] decompressed(long indexed) throws McapException {
    if (size != indexed) {
      throw new McapException("it says " + size + " bytes, and the summary " + indexed);
    }
    return decompressed();
  }

  /** The bytes of its records. */
  byte[] decompressed() throws McapException {
    return compression.decompress(compressed, size, crc);
  }

  /** All whole records of what can be decompressed. */
  Salvage salvage() {
    ChunkCompression.Prefix prefix = compression.decompressPrefix(compressed, size);
    ChunkRecords records = new ChunkRecords(prefix.bytes());
    IOException trouble = prefix.trouble() != null ? prefix.trouble() : records.trouble();
    CRC32 actual = new CRC32();
    actual.update(prefix.bytes());
    if (trouble == null && crc != 0 && crc != actual.getValue()) {
      trouble = new McapException("a chunk's checksum is another: some of its bytes are wrong");
    }
    return new Salvage(records, trouble);
  }
}
