package org.u2sa.recorder.mcap;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.zip.CRC32;
import org.u2sa.recorder.mcap.record.AttachmentIndex;
import org.u2sa.recorder.mcap.record.ChunkIndex;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.recorder.mcap.record.McapSchema;
import org.u2sa.recorder.mcap.record.McapStatistics;
import org.u2sa.recorder.mcap.record.MetadataIndex;
import org.u2sa.recorder.mcap.record.Opcode;
import org.u2sa.recorder.mcap.record.RecordBuffer;

/** Summary section after a file's data: repeated definitions, statistics and indexes. */
final class Summary {
  private static final int FOOTER_LENGTH = 8 + 8 + 4;

  private final Map<Integer, McapSchema> schemas = new TreeMap<>();
  private final Map<Integer, McapChannel> channels = new TreeMap<>();
  private final List<ChunkIndex> chunks = new ArrayList<>();
  private final List<AttachmentIndex> attachments = new ArrayList<>();
  private final List<MetadataIndex> metadata = new ArrayList<>();
  private final MessageCount messages = new MessageCount();

  void add(McapSchema schema) {
    schemas.put(schema.id(), schema);
  }

  void add(McapChannel channel) {
    channels.put(channel.id(), channel);
  }

  void add(ChunkIndex chunk) {
    chunks.add(chunk);
  }

  void add(AttachmentIndex attachment) {
    attachments.add(attachment);
  }

  void add(MetadataIndex index) {
    metadata.add(index);
  }

  void add(McapMessage one) {
    messages.add(one.channelId(), one.logTimeNanos());
  }

  void add(MessageCount more) {
    messages.add(more);
  }

  McapStatistics statistics() {
    return new McapStatistics(
        messages.messages(),
        schemas.size(),
        channels.size(),
        attachments.size(),
        metadata.size(),
        chunks.size(),
        messages.startNanos(),
        messages.endNanos(),
        messages.byChannel());
  }

  /** Writes summary, summary offsets and footer at a file offset. */
  void write(RecordBuffer out, long start, McapOptions options) {
    List<long[]> groups = new ArrayList<>();
    Group group =
        (feature, opcode, write) -> {
          int from = out.length();
          if (options.has(feature)) {
            write.run();
          }
          if (out.length() > from) {
            groups.add(new long[] {opcode, start + from, out.length() - from});
          }
        };
    group.add(
        McapFeature.REPEATED_SCHEMAS,
        Opcode.SCHEMA,
        () -> schemas.values().forEach(schema -> schema.write(out)));
    group.add(
        McapFeature.REPEATED_CHANNELS,
        Opcode.CHANNEL,
        () -> channels.values().forEach(channel -> channel.write(out)));
    group.add(McapFeature.STATISTICS, Opcode.STATISTICS, () -> statistics().write(out));
    group.add(
        McapFeature.CHUNK_INDEX,
        Opcode.CHUNK_INDEX,
        () -> chunks.forEach(index -> index.write(out)));
    group.add(
        McapFeature.ATTACHMENT_INDEX,
        Opcode.ATTACHMENT_INDEX,
        () -> attachments.forEach(index -> index.write(out)));
    group.add(
        McapFeature.METADATA_INDEX,
        Opcode.METADATA_INDEX,
        () -> metadata.forEach(index -> index.write(out)));
    boolean any = out.length() > 0;
    long offsetsAt = options.has(McapFeature.SUMMARY_OFFSETS) ? start + out.length() : 0;
    if (offsetsAt != 0) {
      for (long[] g : groups) {
        out.begin(Opcode.SUMMARY_OFFSET).uint8((int) g[0]).uint64(g[1]).uint64(g[2]).end();
      }
    }
    out.uint8(Opcode.FOOTER).uint64(FOOTER_LENGTH).uint64(any ? start : 0).uint64(offsetsAt);
    CRC32 crc = new CRC32();
    crc.update(out.array(), 0, out.length());
    out.uint32(crc.getValue());
  }

  /** Writes records of one type, if enabled. */
  @FunctionalInterface
  private interface Group {
    void add(McapFeature feature, int opcode, Runnable write);
  }
}
