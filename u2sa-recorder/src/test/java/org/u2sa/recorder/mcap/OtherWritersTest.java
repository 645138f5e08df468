package org.u2sa.recorder.mcap;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.recorder.mcap.record.ChunkIndex;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapException;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.recorder.mcap.record.McapStatistics;
import org.u2sa.recorder.mcap.record.Opcode;
import org.u2sa.recorder.mcap.record.RecordBuffer;

/** Sound files of other programs' writers, with contents that ours does not write. */
class OtherWritersTest {
  @TempDir Path folder;

  /** A file with one chunk that is said to be compressed with zstd, the default of Python's. */
  private Path zstd() throws IOException {
    RecordBuffer out = new RecordBuffer(1 << 10, false);
    out.bytes(Opcode.magic(), 0, Opcode.magic().length);
    out.begin(Opcode.HEADER).string("").string("python").end();
    long chunkAt = out.length();
    out.begin(Opcode.CHUNK).uint64(0).uint64(1).uint64(100).uint32(0).string("zstd");
    int from = out.beginLongLength();
    out.bytes(new byte[20], 0, 20);
    out.endLongLength(from);
    out.end();
    long chunkLength = out.length() - chunkAt;
    out.begin(Opcode.DATA_END).uint32(0).end();
    long summaryAt = out.length();
    new McapChannel(1, 0, "topic1", "cbor", Map.of()).write(out);
    new McapStatistics(2, 0, 1, 0, 0, 1, 0, 1, Map.of(1, 2L)).write(out);
    new ChunkIndex(0, 1, chunkAt, chunkLength, Map.of(), 0, "zstd", 20, 100).write(out);
    out.begin(Opcode.FOOTER).uint64(summaryAt).uint64(0).uint32(0).end();
    out.bytes(Opcode.magic(), 0, Opcode.magic().length);
    return Files.write(folder.resolve("zstd.mcap"), Arrays.copyOf(out.array(), out.length()));
  }

  @Test
  void next_zstd_saysHowToConvertItAndNothingOfDamage() throws IOException {
    try (McapReader reader = McapReader.open(zstd())) {
      assertThatThrownBy(() -> reader.messages(0, channel -> true).next())
          .isInstanceOf(McapException.class)
          .hasMessageContaining("zstd.mcap: chunks are compressed with zstd")
          .hasMessageContaining("mcap compress --compression lz4")
          .hasMessageNotContainingAny("damaged", "recover");
    }
  }

  @Test
  void recover_zstd_saysHowToConvertItAndLeavesNoFile() throws IOException {
    Path whole = folder.resolve("whole.mcap");
    assertThatThrownBy(() -> McapRecovery.recover(zstd(), whole, "test"))
        .isInstanceOf(McapException.class)
        .hasMessageContaining("mcap compress --compression lz4");
    assertThat(whole).doesNotExist();
  }

  @Test
  void open_logTimesFrom2To63_areRefusedInWordsAndLeftOutByRecover() throws IOException {
    Path file = folder.resolve("late.mcap");
    try (McapWriter writer =
        new McapWriter(
            FileChannel.open(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE),
            SmallRecording.options(ChunkCompression.LZ4, 500))) {
      writer.add(new McapChannel(1, 0, "topic1", "cbor", Map.of()));
      for (long nanos : List.of(5L, Long.MIN_VALUE, 7L)) {
        writer.add(new McapMessage(1, 0, nanos, nanos, new byte[1]));
      }
    }
    assertThatThrownBy(() -> McapReader.open(file))
        .isInstanceOf(McapException.class)
        .hasMessageContaining("log times from 9223372036854775808 to")
        .hasMessageContaining("recover it first");

    Path whole = folder.resolve("whole.mcap");
    McapRecovery.Result result = McapRecovery.recover(file, whole, "test");
    assertThat(result.messages()).isEqualTo(2);
    assertThat(result.trouble().orElseThrow()).contains("log time of 2^63 ns");
    assertThat(SmallRecording.read(whole)).hasSize(2);
  }
}
