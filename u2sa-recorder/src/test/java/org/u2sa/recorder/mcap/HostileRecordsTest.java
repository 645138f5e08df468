package org.u2sa.recorder.mcap;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.Map;
import java.util.zip.CRC32;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.recorder.mcap.record.ChunkIndex;
import org.u2sa.recorder.mcap.record.McapException;
import org.u2sa.recorder.mcap.record.McapMetadata;
import org.u2sa.recorder.mcap.record.Opcode;
import org.u2sa.recorder.mcap.record.RecordBuffer;
import org.u2sa.recorder.mcap.record.RecordFields;

/** Records and chunks made to fill the memory of a reader. */
class HostileRecordsTest {
  @TempDir Path folder;

  private Path file() {
    return folder.resolve("hostile.mcap");
  }

  private static ChunkIndex of(int number, long endNanos, Map<Integer, Long> channels) {
    return new ChunkIndex(0, endNanos, number, 10, channels, 0, "", 100, 100);
  }

  private static ChunkIndex chunk(int number, long startNanos, long size) {
    return new ChunkIndex(startNanos, 1_000, number, 10, Map.of(), 0, "", size, size);
  }

  private IOException nextOf(long length) throws IOException {
    ByteBuffer prefix = ByteBuffer.allocate(Opcode.PREFIX).order(ByteOrder.LITTLE_ENDIAN);
    Files.write(file(), prefix.put((byte) Opcode.METADATA).putLong(length).array());
    try (FileChannel channel = FileChannel.open(file(), StandardOpenOption.READ)) {
      new RecordStream(channel, 0).next();
      throw new AssertionError("a record of " + length + " bytes was read");
    } catch (IOException e) {
      return e;
    }
  }

  @Test
  void next_recordOfGreatestLength_isTakenForOneThatBreaksOff() throws IOException {
    assertThat(nextOf(ReadLimits.MAX_LENGTH))
        .isInstanceOf(EOFException.class)
        .hasMessageContaining("within a record");
  }

  @ParameterizedTest
  @ValueSource(longs = {ReadLimits.MAX_LENGTH + 1, Long.MAX_VALUE, -1, Long.MIN_VALUE})
  void next_longerRecord_isNone(long length) throws IOException {
    assertThat(nextOf(length))
        .isInstanceOf(McapException.class)
        .hasMessageContaining("no valid record: opcode 12, length " + length);
  }

  private RecordBuffer twoRecords() {
    RecordBuffer out = new RecordBuffer(100, false);
    new McapMetadata("a", Map.of("b", "c")).write(out);
    new McapMetadata("second", Map.of()).write(out);
    return out;
  }

  @Test
  void next_recordsUpToTheFilesLastByte_areRead() throws IOException {
    RecordBuffer out = twoRecords();
    Files.write(file(), Arrays.copyOf(out.array(), out.length()));
    try (FileChannel channel = FileChannel.open(file(), StandardOpenOption.READ)) {
      RecordStream stream = new RecordStream(channel, 0);
      assertThat(McapMetadata.read(stream.next().fields()).name()).isEqualTo("a");
      assertThat(stream.position()).isEqualTo(Opcode.PREFIX + 4 + 1 + 4 + 4 + 1 + 4 + 1);
      assertThat(McapMetadata.read(stream.next().fields()).name()).isEqualTo("second");
      assertThatThrownBy(stream::next)
          .isInstanceOf(EOFException.class)
          .hasMessage("the file breaks off at byte " + out.length());
    }
  }

  @Test
  void next_secondRecordCut_saysWhere() throws IOException {
    RecordBuffer out = twoRecords();
    long second = Opcode.PREFIX + 4 + 1 + 4 + 4 + 1 + 4 + 1;
    for (int length = (int) second + 1; length < out.length(); length++) {
      Files.write(file(), Arrays.copyOf(out.array(), length));
      try (FileChannel channel = FileChannel.open(file(), StandardOpenOption.READ)) {
        RecordStream stream = new RecordStream(channel, 0);
        stream.next();
        boolean hasPrefix = length >= second + Opcode.PREFIX;
        assertThatThrownBy(stream::next)
            .isInstanceOf(EOFException.class)
            .hasMessage(
                "the file breaks off at byte " + length + (hasPrefix ? ", within a record" : ""));
      }
    }
  }

  @Test
  void next_recordWithoutContent_isRead() throws IOException {
    Files.write(file(), new byte[] {(byte) 0x90, 0, 0, 0, 0, 0, 0, 0, 0});
    try (FileChannel channel = FileChannel.open(file(), StandardOpenOption.READ)) {
      RecordStream.Entry entry = new RecordStream(channel, 0).next();
      assertThat(entry.opcode()).isEqualTo(0x90);
      assertThat(entry.content()).isEmpty();
    }
  }

  @Test
  void bytes_moreThanTheFileHolds_areNotAllocated() throws IOException {
    Files.write(file(), new byte[100]);
    try (FileChannel channel = FileChannel.open(file(), StandardOpenOption.READ)) {
      RecordStream stream = new RecordStream(channel, 40);
      assertThat(stream.bytes(60)).hasSize(60);
      assertThatThrownBy(() -> stream.bytes(61))
          .isInstanceOf(EOFException.class)
          .hasMessageContaining("within a record");
      assertThatThrownBy(() -> stream.bytes(ReadLimits.MAX_LENGTH))
          .isInstanceOf(EOFException.class);
      assertThatThrownBy(() -> stream.bytes(ReadLimits.MAX_LENGTH + 1))
          .isInstanceOf(McapException.class)
          .hasMessageContaining("expected at most " + ReadLimits.MAX_LENGTH);
    }
  }

  private static RecordFields chunkOfSize(long size) {
    RecordBuffer out = new RecordBuffer(100, false);
    out.uint64(0).uint64(0).uint64(size).uint32(0).string("").uint64(3).bytes(new byte[3], 0, 3);
    return new RecordFields(Arrays.copyOf(out.array(), out.length()));
  }

  @Test
  void read_chunkOfGreatestSize_isReadAndFoundTooShort() throws IOException {
    ChunkContent chunk = ChunkContent.read(chunkOfSize(ReadLimits.MAX_LENGTH));
    assertThat(chunk.size()).isEqualTo(ReadLimits.MAX_LENGTH);
    assertThatThrownBy(chunk::decompressed)
        .isInstanceOf(McapException.class)
        .hasMessageContaining("holds 3 of its");
  }

  @ParameterizedTest
  @ValueSource(longs = {ReadLimits.MAX_LENGTH + 1, Long.MAX_VALUE, -1})
  void read_chunkOfImpossibleSize_isRefused(long size) {
    assertThatThrownBy(() -> ChunkContent.read(chunkOfSize(size)))
        .isInstanceOf(McapException.class)
        .hasMessage("a chunk of " + size + " bytes: above the read limit");
  }

  @Test
  void read_emptyChunk_isRead() throws IOException {
    assertThat(ChunkContent.read(chunkOfSize(0)).size()).isZero();
  }

  private static ChunkContent chunk(byte[] records, long size, long crc) {
    return new ChunkContent(size, crc, ChunkCompression.NONE, records);
  }

  @Test
  void salvage_soundChunk_hasAllRecordsAndNoTrouble() throws IOException {
    RecordBuffer out = twoRecords();
    byte[] records = Arrays.copyOf(out.array(), out.length());
    CRC32 crc = new CRC32();
    crc.update(records);
    for (long known : new long[] {0, crc.getValue()}) {
      ChunkContent.Salvage salvage = chunk(records, records.length, known).salvage();
      assertThat(salvage.trouble()).isNull();
      assertThat(salvage.records()).hasSize(2);
      assertThat(chunk(records, records.length, known).records()).hasSize(2);
    }
  }

  @Test
  void salvage_otherChecksum_saysSo() {
    RecordBuffer out = twoRecords();
    byte[] records = Arrays.copyOf(out.array(), out.length());
    assertThat(chunk(records, records.length, 1).salvage().trouble())
        .hasMessageContaining("checksum is wrong");
  }

  @Test
  void salvage_recordCut_hasThoseBeforeIt() {
    RecordBuffer out = twoRecords();
    byte[] records = Arrays.copyOf(out.array(), out.length() - 1);
    ChunkContent cut = chunk(records, records.length, 0);
    assertThat(cut.salvage().records()).hasSize(1);
    assertThat(cut.salvage().trouble()).hasMessageContaining("its record has only");
    assertThatThrownBy(cut::records)
        .isInstanceOf(McapException.class)
        .hasMessageContaining("a chunk is damaged");
  }

  @Test
  void salvage_framesEndMissing_saysWhatTheDecompressorSays() {
    byte[] noFrame = {1, 2, 3, 4, 5, 6, 7, 8};
    ChunkContent chunk = new ChunkContent(100, 0, ChunkCompression.LZ4, noFrame);
    assertThat(chunk.salvage().records()).isEmpty();
    assertThat(chunk.salvage().trouble()).isNotNull();
  }
}
