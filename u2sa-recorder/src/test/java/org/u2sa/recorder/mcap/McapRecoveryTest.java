package org.u2sa.recorder.mcap;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.StreamSupport;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.u2sa.recorder.mcap.record.ChunkIndex;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.recorder.mcap.record.McapMetadata;
import org.u2sa.recorder.mcap.record.Opcode;

class McapRecoveryTest {
  private static final int CHUNK_BYTES = 250;

  @TempDir Path folder;
  private String trouble;

  /** What must be found of a file of uncompressed chunks that is cut: each message's last byte. */
  private static List<Long> endsOfMessages(Path file) throws IOException {
    List<Long> ends = new ArrayList<>();
    try (var channel = Files.newByteChannel(file)) {
      RecordStream stream = new RecordStream(channel, Opcode.magic().length);
      RecordStream.Entry entry = stream.next();
      while (entry.opcode() != Opcode.DATA_END) {
        if (entry.opcode() == Opcode.CHUNK) {
          ChunkContent chunk = ChunkContent.read(entry.fields());
          long recordsAt = entry.offset() + entry.length() - chunk.compressed().length;
          for (RecordStream.Entry record : chunk.records()) {
            if (record.opcode() == Opcode.MESSAGE) {
              ends.add(recordsAt + record.offset() + record.length());
            }
          }
        }
        entry = stream.next();
      }
    }
    return ends;
  }

  @Test
  void recover_cutAtEveryByte_findsEveryMessageBeforeTheCut() throws IOException {
    Path file = folder.resolve("a.mcap");
    List<String> written =
        SmallRecording.texts(
            SmallRecording.write(
                file, SmallRecording.options(ChunkCompression.NONE, CHUNK_BYTES), 12));
    List<Long> ends = endsOfMessages(file);
    assertThat(ends).hasSameSizeAs(written);
    byte[] bytes = Files.readAllBytes(file);
    for (int length = 0; length <= bytes.length; length++) {
      int cut = length;
      long expected = ends.stream().filter(end -> end <= cut).count();
      assertThat(recoveredOfFirst(cut, bytes))
          .as("cut after %d of %d bytes", cut, bytes.length)
          .isEqualTo(written.subList(0, (int) expected));
    }
  }

  @Test
  void recover_compressedCutAtEveryByte_findsEveryMessageOfWholeChunks() throws IOException {
    Path file = folder.resolve("a.mcap");
    List<String> written =
        SmallRecording.texts(
            SmallRecording.write(
                file, SmallRecording.options(ChunkCompression.LZ4, CHUNK_BYTES), 12));
    List<ChunkIndex> chunks = new ArrayList<>();
    byte[] bytes = Files.readAllBytes(file);
    List<Integer> messagesBy = wholeChunks(file, chunks);
    for (int cut = 0; cut <= bytes.length; cut++) {
      int expected = 0;
      for (int i = 0; i < chunks.size(); i++) {
        expected =
            chunks.get(i).offset() + chunks.get(i).length() <= cut ? messagesBy.get(i) : expected;
      }
      List<String> found = recoveredOfFirst(cut, bytes);
      assertThat(found).as("cut after %d", cut).hasSizeGreaterThanOrEqualTo(expected);
      assertThat(written.subList(0, found.size())).isEqualTo(found);
    }
  }

  private static List<Integer> wholeChunks(Path file, List<ChunkIndex> chunks) throws IOException {
    List<Integer> counts = new ArrayList<>();
    try (var channel = Files.newByteChannel(file)) {
      RecordStream stream = new RecordStream(channel, Opcode.magic().length);
      int count = 0;
      for (RecordStream.Entry e = stream.next(); e.opcode() != Opcode.FOOTER; e = stream.next()) {
        if (e.opcode() == Opcode.CHUNK) {
          count +=
              (int)
                  StreamSupport.stream(ChunkContent.read(e.fields()).records().spliterator(), false)
                      .filter(record -> record.opcode() == Opcode.MESSAGE)
                      .count();
          counts.add(count);
        } else if (e.opcode() == Opcode.CHUNK_INDEX) {
          chunks.add(ChunkIndex.read(e.fields()));
        }
      }
    }
    return counts;
  }

  @ParameterizedTest
  @EnumSource(ChunkCompression.class)
  void recover_oneByteChangedAnywhere_neverFails(ChunkCompression compression) throws IOException {
    Path file = folder.resolve("a.mcap");
    SmallRecording.write(file, SmallRecording.options(compression, CHUNK_BYTES), 30);
    byte[] bytes = Files.readAllBytes(file);
    Random random = new Random(3);
    for (int i = 0; i < 100; i++) {
      byte[] damaged = bytes.clone();
      damaged[random.nextInt(damaged.length)] ^= (byte) (1 << random.nextInt(8));
      Path broken = folder.resolve("broken.mcap");
      Path whole = folder.resolve("whole.mcap");
      Files.write(broken, damaged);
      Files.deleteIfExists(whole);
      McapRecovery.recover(broken, whole, "test");
      SmallRecording.read(whole); // it can be read, whatever is in it
    }
  }

  @Test
  void recover_chunkDamagedInTheMiddle_keepsTheChunksAfterIt() throws IOException {
    int lastBlock = -8; // from the chunk's end
    requireOtherChunksAreKept(lastBlock);
  }

  @Test
  void recover_chunkOfUnknownCompression_keepsTheChunksAfterIt() throws IOException {
    int nameOfCompression = 1 + 8 + 8 + 8 + 8 + 4 + 4; // opcode, length, times, size, CRC, length
    requireOtherChunksAreKept(nameOfCompression);
  }

  /** Changes a byte of the second chunk: at a place from its begin, or if negative from its end. */
  private void requireOtherChunksAreKept(int place) throws IOException {
    Path file = folder.resolve("a.mcap");
    List<String> written =
        SmallRecording.texts(
            SmallRecording.write(
                file, SmallRecording.options(ChunkCompression.LZ4, CHUNK_BYTES), 60));
    List<ChunkIndex> chunks = new ArrayList<>();
    wholeChunks(file, chunks);
    byte[] bytes = Files.readAllBytes(file);
    ChunkIndex second = chunks.get(1);
    bytes[(int) (second.offset() + (place < 0 ? second.length() : 0)) + place] ^= 0x55;
    List<String> found = recovered(bytes, true);
    List<String> ofOtherChunks = new ArrayList<>(written);
    List<Integer> messagesBy = wholeChunks(file, new ArrayList<>());
    ofOtherChunks.subList(messagesBy.get(0), messagesBy.get(1)).clear();
    assertThat(found).containsAll(ofOtherChunks).hasSizeLessThanOrEqualTo(written.size());
  }

  @Test
  void recover_wholeFile_saysThatNothingWasWrong() throws IOException {
    Path file = folder.resolve("a.mcap");
    List<McapMessage> written =
        SmallRecording.write(file, SmallRecording.options(ChunkCompression.LZ4, CHUNK_BYTES), 30);
    Path whole = folder.resolve("whole.mcap");
    McapRecovery.Result result = McapRecovery.recover(file, whole, "test");
    assertThat(result.trouble()).isEmpty();
    assertThat(result.messages()).isEqualTo(30);
    assertThat(SmallRecording.read(whole)).isEqualTo(SmallRecording.texts(written));
    try (McapReader reader = McapReader.open(whole)) {
      assertThat(reader.attachmentNames()).containsExactly("system.xml");
      assertThat(reader.metadata()).extracting(McapMetadata::name).containsExactly("run");
    }
  }

  @Test
  @Tag("long")
  void recover_largeFileCutAt1000RandomPlaces_findsEveryMessageBeforeTheCut() throws IOException {
    Path file = folder.resolve("a.mcap");
    List<String> written =
        SmallRecording.texts(
            SmallRecording.write(
                file, SmallRecording.options(ChunkCompression.NONE, 1 << 14), 4_000));
    List<Long> ends = endsOfMessages(file);
    byte[] bytes = Files.readAllBytes(file);
    Random random = new Random(11);
    for (int i = 0; i < 1000; i++) {
      int cut = random.nextInt(bytes.length);
      long expected = ends.stream().filter(end -> end <= cut).count();
      assertThat(recoveredOfFirst(cut, bytes))
          .as("cut after %d of %d bytes", cut, bytes.length)
          .isEqualTo(written.subList(0, (int) expected));
    }
  }

  private List<String> recoveredOfFirst(int cut, byte[] bytes) throws IOException {
    List<String> messages = recovered(Arrays.copyOf(bytes, cut), cut < bytes.length);
    if (cut >= Opcode.magic().length && cut < bytes.length) {
      assertThat(trouble).startsWith("the file breaks off at byte " + cut);
    }
    return messages;
  }

  private List<String> recovered(byte[] bytes, boolean isBroken) throws IOException {
    Path broken = folder.resolve("broken.mcap");
    Path whole = folder.resolve("whole.mcap");
    Files.write(broken, bytes);
    Files.deleteIfExists(whole);
    McapRecovery.Result result = McapRecovery.recover(broken, whole, "test");
    assertThat(result.trouble().isPresent()).isEqualTo(isBroken);
    trouble = result.trouble().orElse("");
    List<String> messages = SmallRecording.read(whole);
    assertThat((long) messages.size()).isEqualTo(result.messages());
    return messages;
  }

  @Test
  void recover_chunksLargerThanTheHeapHolds_areLeftOutAndSaid() throws IOException {
    Path file = folder.resolve("a.mcap");
    SmallRecording.write(file, SmallRecording.options(ChunkCompression.LZ4, CHUNK_BYTES), 12);
    McapRecovery.Result none =
        McapRecovery.recover(file, folder.resolve("none.mcap"), "test", CHUNK_BYTES / 2);
    assertThat(none.messages()).isZero();
    assertThat(none.damagedChunks()).isPositive();
    assertThat(none.trouble().orElseThrow()).contains("expected at most " + CHUNK_BYTES / 2);

    McapRecovery.Result all =
        McapRecovery.recover(file, folder.resolve("all.mcap"), "test", 10 * CHUNK_BYTES);
    assertThat(all.messages()).isPositive();
    assertThat(all.damagedChunks()).isZero();
  }
}
