package org.u2sa.recorder.mcap;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.u2sa.recorder.mcap.record.McapAttachment;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.recorder.mcap.record.McapMetadata;
import org.u2sa.recorder.mcap.record.McapSchema;

/** Writes recordings of a few channels, the same for the same arguments. */
final class SmallRecording {
  private static final long STEP_NANOS = 10_000_000L;
  private static final int CHANNELS = 3;

  private SmallRecording() {}

  static McapOptions options(ChunkCompression compression, int chunkBytes) {
    return new McapOptions(
        EnumSet.complementOf(EnumSet.of(McapFeature.LATER_FIELDS)),
        compression,
        chunkBytes,
        Long.MAX_VALUE,
        "",
        "test");
  }

  static List<McapMessage> write(Path file, McapOptions options, int messages) throws IOException {
    try (McapWriter writer =
        new McapWriter(
            FileChannel.open(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE),
            options)) {
      writer.add(new McapMetadata("run", Map.of("seed", "1")));
      writer.add(new McapAttachment(0, 0, "system.xml", "text/xml", new byte[] {1, 2, 3}));
      return addTo(writer, messages);
    }
  }

  static List<McapMessage> addTo(McapWriter writer, int messages) throws IOException {
    Random random = new Random(7);
    writer.add(new McapSchema(1, "Thing", "jsonschema", "{}".getBytes()));
    List<McapMessage> all = new ArrayList<>();
    for (int i = 0; i < messages; i++) {
      int channel = 1 + i % CHANNELS;
      if (i < CHANNELS) {
        writer.add(new McapChannel(channel, 1, "topic" + channel, "cbor", Map.of()));
      }
      byte[] data = new byte[random.nextInt(40)];
      random.nextBytes(data);
      long nanos = i * STEP_NANOS;
      McapMessage message = new McapMessage(channel, i / CHANNELS, nanos, nanos + 1, data);
      writer.add(message);
      all.add(message);
    }
    return all;
  }

  /** Messages as texts, which can be compared. */
  static List<String> texts(List<McapMessage> messages) {
    List<String> texts = new ArrayList<>();
    for (McapMessage m : messages) {
      texts.add(
          m.channelId()
              + " "
              + m.sequence()
              + " "
              + m.logTimeNanos()
              + " "
              + m.publishTimeNanos()
              + " "
              + java.util.HexFormat.of().formatHex(m.data()));
    }
    return texts;
  }

  static List<String> read(Path file) throws IOException {
    try (McapReader reader = McapReader.open(file)) {
      return texts(read(reader.messages(Long.MIN_VALUE, channel -> true)));
    }
  }

  static List<McapMessage> read(McapCursor cursor) throws IOException {
    List<McapMessage> all = new ArrayList<>();
    for (var next = cursor.next(); next.isPresent(); next = cursor.next()) {
      all.add(next.get());
    }
    return all;
  }
}
