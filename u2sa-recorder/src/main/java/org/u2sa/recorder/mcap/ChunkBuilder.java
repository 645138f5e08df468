package org.u2sa.recorder.mcap;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.zip.CRC32;
import org.u2sa.recorder.mcap.record.ChunkIndex;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.recorder.mcap.record.McapSchema;
import org.u2sa.recorder.mcap.record.Opcode;
import org.u2sa.recorder.mcap.record.RecordBuffer;

/** The chunk being filled: its records and the message offsets of each channel. */
final class ChunkBuilder {
  private static final int FIRST_CAPACITY = 1 << 16;
  private static final int FIRST_ENTRIES = 64;

  private final McapOptions options;
  private final RecordBuffer records = new RecordBuffer(FIRST_CAPACITY, false);
  private final List<Entries> entries = new ArrayList<>(); // by channel; null if none yet
  private final List<McapSchema> schemas = new ArrayList<>();
  private final List<McapChannel> channels = new ArrayList<>();
  private final List<McapSchema> schemasBefore = new ArrayList<>(); // of the previous chunk
  private final List<McapChannel> channelsBefore = new ArrayList<>();
  private final MessageCount count = new MessageCount();

  /** Log time and offset of each message of a channel, alternating. */
  private static final class Entries {
    private long[] values = new long[FIRST_ENTRIES];
    private int size;

    void add(long logTimeNanos, long offset) {
      if (size == values.length) {
        values = Arrays.copyOf(values, 2 * size);
      }
      values[size++] = logTimeNanos;
      values[size++] = offset;
    }
  }

  ChunkBuilder(McapOptions options) {
    this.options = options;
  }

  void add(McapSchema schema) {
    schema.write(records);
    schemas.add(schema);
  }

  void add(McapChannel channel) {
    channel.write(records);
    channels.add(channel);
  }

  void add(McapMessage message) {
    if (count.messages() == 0) {
      schemasBefore.forEach(schema -> schema.write(records));
      channelsBefore.forEach(channel -> channel.write(records));
    }
    if (options.has(McapFeature.MESSAGE_INDEX)) {
      entriesOf(message.channelId()).add(message.logTimeNanos(), records.length());
    }
    message.write(records);
    count.add(message.channelId(), message.logTimeNanos());
  }

  private Entries entriesOf(int channel) {
    while (entries.size() <= channel) {
      entries.add(null);
    }
    Entries list = entries.get(channel);
    if (list == null) {
      list = new Entries();
      entries.set(channel, list);
    }
    return list;
  }

  boolean isEmpty() {
    return records.length() == 0;
  }

  /** Whether a message with this time belongs to the next chunk. */
  boolean isDone(long logTimeNanos) {
    return count.messages() > 0
        && (records.length() >= options.chunkBytes()
            || logTimeNanos - count.startNanos() >= options.chunkNanos());
  }

  MessageCount count() {
    return count;
  }

  List<McapSchema> schemas() {
    return schemas;
  }

  List<McapChannel> channels() {
    return channels;
  }

  /** Writes chunk and message indexes at a file offset, and returns their positions. */
  ChunkIndex write(RecordBuffer out, long position) {
    int length = records.length();
    CRC32 crc = new CRC32();
    crc.update(records.array(), 0, length);
    String compression = options.compression().inFile();
    long offset = position + out.length();
    out.begin(Opcode.CHUNK).uint64(count.startNanos()).uint64(count.endNanos());
    out.uint64(length).uint32(crc.getValue()).string(compression);
    int from = out.beginLongLength();
    options.compression().compress(records.array(), length, out);
    int compressed = out.endLongLength(from);
    out.endAsIs();
    long indexesAt = position + out.length();
    Map<Integer, Long> indexes = new LinkedHashMap<>();
    for (int channel = 0; channel < entries.size(); channel++) {
      Entries list = entries.get(channel);
      if (list != null && list.size > 0) {
        indexes.put(channel, position + out.length());
        writeIndex(out, channel, list);
      }
    }
    return new ChunkIndex(
        count.startNanos(),
        count.endNanos(),
        offset,
        indexesAt - offset,
        indexes,
        position + out.length() - indexesAt,
        compression,
        compressed,
        length);
  }

  private static void writeIndex(RecordBuffer out, int channel, Entries list) {
    out.begin(Opcode.MESSAGE_INDEX).uint16(channel);
    int array = out.beginLength();
    for (int i = 0; i < list.size; i++) {
      out.uint64(list.values[i]);
    }
    out.endLength(array);
    out.end();
  }

  /** Starts the next chunk after this one was written. */
  void next() {
    if (count.messages() > 0) { // it contains definitions
      schemasBefore.clear();
      channelsBefore.clear();
    }
    if (options.has(McapFeature.DEFINITIONS_TWICE)) {
      schemasBefore.addAll(schemas);
      channelsBefore.addAll(channels);
    }
    clear();
    schemas.clear();
    channels.clear();
  }

  /** Resets to the definitions only, because this chunk could not be written. */
  void dropMessages() {
    clear();
    schemas.forEach(schema -> schema.write(records));
    channels.forEach(channel -> channel.write(records));
  }

  private void clear() {
    records.clear();
    entries.stream().filter(Objects::nonNull).forEach(list -> list.size = 0);
    count.clear();
  }
}
