package org.u2sa.recorder.mcap.record;

import java.util.Map;
import java.util.TreeMap;

/**
 * Statistics of a file.
 *
 * @param messages number of messages
 * @param schemas number of schemas
 * @param channels number of channels
 * @param attachments number of attachments
 * @param metadata number of metadata records
 * @param chunks number of chunks
 * @param startNanos log time of the earliest message [ns]; 0 if none
 * @param endNanos log time of the latest message [ns]; 0 if none
 * @param messagesByChannel number of messages by channel ID
 */
public record McapStatistics(
    long messages,
    int schemas,
    long channels,
    long attachments,
    long metadata,
    long chunks,
    long startNanos,
    long endNanos,
    Map<Integer, Long> messagesByChannel) {
  /** Appends the record, opcode and length included. */
  public void write(RecordBuffer out) {
    out.begin(Opcode.STATISTICS).uint64(messages).uint16(schemas).uint32(channels);
    out.uint32(attachments).uint32(metadata).uint32(chunks).uint64(startNanos).uint64(endNanos);
    int map = out.beginLength();
    messagesByChannel.forEach((channel, count) -> out.uint16(channel).uint64(count));
    out.endLength(map);
    out.end();
  }

  public static McapStatistics read(RecordFields in) throws McapException {
    long messages = in.uint64();
    int schemas = in.uint16();
    long channels = in.uint32();
    long attachments = in.uint32();
    long metadata = in.uint32();
    long chunks = in.uint32();
    long start = in.uint64();
    long end = in.uint64();
    RecordFields map = in.part();
    Map<Integer, Long> counts = new TreeMap<>();
    while (map.remaining() > 0) {
      counts.put(map.uint16(), map.uint64());
    }
    return new McapStatistics(
        messages, schemas, channels, attachments, metadata, chunks, start, end, counts);
  }
}
