package org.u2sa.cli.record;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.recorder.mcap.ChunkCompression;
import org.u2sa.recorder.mcap.McapOptions;
import org.u2sa.recorder.mcap.McapWriter;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.recorder.mcap.record.McapMetadata;

class RecordingPartsTest {
  private static final long SECOND = 1_000_000_000L;

  @TempDir private Path folder;

  private Path write(String name, String seed, long fromS, long toS) throws IOException {
    Path file = folder.resolve(name);
    try (McapWriter writer =
        new McapWriter(
            Files.newByteChannel(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE),
            McapOptions.usual(ChunkCompression.LZ4, "test"))) {
      writer.add(new McapMetadata("run", Map.of("seed", seed)));
      writer.add(new McapChannel(1, 0, "topic", "none", Map.of()));
      for (long second = fromS; second <= toS; second++) {
        writer.add(new McapMessage(1, second, second * SECOND, second * SECOND, new byte[1]));
      }
    }
    return file;
  }

  @Test
  void beginningWith_numberedFiles_areThoseThatFollow() throws IOException {
    Path first = write("r-0001.mcap", "5", 0, 10);
    Path second = write("r-0002.mcap", "5", 10, 20);
    Path third = write("r-0003.mcap", "5", 21, 30);
    write("r-0005.mcap", "5", 31, 40); // not the next one
    assertThat(RecordingParts.beginningWith(first)).containsExactly(first, second, third);
    assertThat(RecordingParts.beginningWith(second)).containsExactly(second, third);
  }

  @Test
  void othersNotRead_splitRecording_areNamed() throws IOException {
    Path first = write("r-0001.mcap", "5", 0, 10);
    assertThat(RecordingParts.othersNotRead(first)).isEmpty();
    Path second = write("r-0002.mcap", "5", 10, 20);
    assertThat(RecordingParts.othersNotRead(first).orElseThrow()).endsWith("not read: " + second);
    Path third = write("r-0003.mcap", "5", 21, 30);
    assertThat(RecordingParts.othersNotRead(first).orElseThrow())
        .endsWith("not read: 2 more files, " + second + " to " + third);
    assertThat(RecordingParts.othersNotRead(second).orElseThrow())
        .endsWith("not read: 2 more files, " + first + " to " + third);
    assertThat(RecordingParts.othersNotRead(third).orElseThrow())
        .endsWith("not read: 2 more files, " + first + " to " + second);
    Files.writeString(second, "damaged");
    assertThat(RecordingParts.othersNotRead(first)).isEmpty();
  }

  @Test
  void beginningWith_nextBeginsBeforeThisEnds_isAnotherRecording() throws IOException {
    Path first = write("r-0001.mcap", "5", 0, 10);
    write("r-0002.mcap", "5", 0, 10);
    assertThat(RecordingParts.beginningWith(first)).containsExactly(first);
  }

  @Test
  void beginningWith_nextHasOtherFacts_isAnotherRecording() throws IOException {
    Path first = write("r-0001.mcap", "5", 0, 10);
    write("r-0002.mcap", "6", 10, 20);
    assertThat(RecordingParts.beginningWith(first)).containsExactly(first);
  }

  @Test
  void beginningWith_noSuchFile_isRefused() {
    assertThatThrownBy(() -> RecordingParts.beginningWith(folder.resolve("none.mcap")))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("none.mcap");
  }
}
