package org.u2sa.recorder.mcap;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.recorder.SmallDisk;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.recorder.mcap.record.McapSchema;

/** What a writer leaves on a disk that fills up, and is emptied again. */
class FullDiskTest {
  @TempDir Path folder;

  private static McapMessage message(int i) {
    return new McapMessage(1, i, i, i, new byte[100]);
  }

  @Test
  void add_diskFullThenFreed_losesCountedMessagesOnly() throws IOException {
    Path path = folder.resolve("a.mcap");
    SmallDisk disk = new SmallDisk(5_000);
    McapWriter writer =
        new McapWriter(disk.create(path), SmallRecording.options(ChunkCompression.NONE, 1_000));
    writer.add(new McapSchema(1, "Thing", "jsonschema", new byte[] {'{', '}'}));
    writer.add(new McapChannel(1, 1, "t", "cbor", Map.of()));
    int refusals = 0;
    for (int i = 0; i < 100; i++) {
      if (i == 80) {
        disk.room(1_000_000);
      }
      try {
        writer.add(message(i));
      } catch (IOException e) {
        refusals++;
      }
    }
    writer.close();
    assertThat(refusals).isPositive();
    try (McapReader reader = McapReader.open(path)) {
      assertThat(reader.statistics().messages() + writer.lost()).isEqualTo(100);
      assertThat(SmallRecording.read(reader.messages(0, channel -> true)))
          .extracting(McapMessage::sequence)
          .startsWith(0L, 1L, 2L)
          .endsWith(98L, 99L)
          .isSorted();
    }
  }

  @Test
  void close_diskFull_leavesWholeRecordsThatCanBeRecovered() throws IOException {
    Path path = folder.resolve("a.mcap");
    McapWriter writer =
        new McapWriter(
            new SmallDisk(5_000).create(path),
            SmallRecording.options(ChunkCompression.NONE, 1_000));
    writer.add(new McapChannel(1, 0, "t", "cbor", Map.of()));
    for (int i = 0; i < 100; i++) {
      addIgnoringFullDisk(writer, i);
    }
    closeIgnoringFullDisk(writer);
    assertThat(Files.size(path)).isEqualTo(writer.position());
    long inFile = writer.statistics().messages();
    assertThat(inFile + writer.lost()).isEqualTo(100);
    assertThat(inFile).isGreaterThan(20);
    Path whole = folder.resolve("whole.mcap");
    assertThat(McapRecovery.recover(path, whole, "test").messages()).isEqualTo(inFile);
  }

  private static void addIgnoringFullDisk(McapWriter writer, int i) {
    try {
      writer.add(message(i));
    } catch (IOException e) {
      assertThat(e).hasMessage("No space left on device");
    }
  }

  private static void closeIgnoringFullDisk(McapWriter writer) {
    try {
      writer.close();
    } catch (IOException e) {
      assertThat(e).hasMessage("No space left on device");
    }
  }

  @Test
  void add_firstChunkLost_definesItsChannelsAgain() throws IOException {
    Path path = folder.resolve("a.mcap");
    SmallDisk disk = new SmallDisk(100);
    McapWriter writer =
        new McapWriter(disk.create(path), SmallRecording.options(ChunkCompression.NONE, 1_000));
    writer.add(new McapSchema(1, "Thing", "jsonschema", new byte[] {'{', '}'}));
    writer.add(new McapChannel(1, 1, "t", "cbor", Map.of()));
    for (int i = 0; i < 10; i++) {
      addIgnoringFullDisk(writer, i);
    }
    disk.room(100_000);
    writer.close();
    try (McapReader reader = McapReader.open(path)) {
      assertThat(reader.channels()).containsOnlyKeys(1);
      assertThat(reader.schemas()).containsOnlyKeys(1);
      assertThat(reader.statistics().messages()).isEqualTo(10 - writer.lost()).isPositive();
    }
  }
}
