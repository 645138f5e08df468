package org.u2sa.recorder.mcap.record;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Position and content of a chunk.
 *
 * @param startNanos log time of its earliest message [ns]
 * @param endNanos log time of its latest message [ns]
 * @param offset file offset of its record [B]
 * @param length length of its record [B]
 * @param messageIndexes offsets of its message indexes, by channel
 * @param messageIndexLength length of all its message indexes [B]
 * @param compression compression according to the chunk
 * @param compressedSize compressed size of its records [B]
 * @param size uncompressed size of its records [B]
 */
public record ChunkIndex(
    long startNanos,
    long endNanos,
    long offset,
    long length,
    Map<Integer, Long> messageIndexes,
    long messageIndexLength,
    String compression,
    long compressedSize,
    long size) {
  /** Appends the record, opcode and length included. */
  public void write(RecordBuffer out) {
    out.begin(Opcode.CHUNK_INDEX).uint64(startNanos).uint64(endNanos);
    out.uint64(offset).uint64(length);
    int map = out.beginLength();
    messageIndexes.forEach((channel, index) -> out.uint16(channel).uint64(index));
    out.endLength(map);
    out.uint64(messageIndexLength).string(compression).uint64(compressedSize).uint64(size).end();
  }

  public static ChunkIndex read(RecordFields in) throws McapException {
    long start = in.uint64();
    long end = in.uint64();
    long offset = in.uint64();
    long length = in.uint64();
    RecordFields map = in.part();
    Map<Integer, Long> indexes = new LinkedHashMap<>();
    while (map.remaining() > 0) {
      indexes.put(map.uint16(), map.uint64());
    }
    return new ChunkIndex(
        start, end, offset, length, indexes, in.uint64(), in.string(), in.uint64(), in.uint64());
  }
}
