package org.u2sa.recorder.mcap;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.recorder.mcap.record.Opcode;

/** One flipped bit costs the messages of one chunk at most, wherever in the file it is. */
class DamageTest {
  private static final int CHUNK_BYTES = 350;
  private static final int MESSAGES = 30;
  private static final Map<Integer, String> TOPICS = Map.of(1, "topic1", 2, "topic2", 3, "topic3");

  @TempDir Path folder;
  private Path broken;
  private Path whole;

  /** The place of a chunk, and its messages. */
  private record Chunk(long from, long to, List<String> messages) {}

  @BeforeEach
  void nameFiles() {
    broken = folder.resolve("broken.mcap");
    whole = folder.resolve("whole.mcap");
  }

  private static McapOptions definedOnce(ChunkCompression compression) {
    return new McapOptions(
        EnumSet.complementOf(EnumSet.of(McapFeature.LATER_FIELDS, McapFeature.DEFINITIONS_TWICE)),
        compression,
        CHUNK_BYTES,
        Long.MAX_VALUE,
        "",
        "test");
  }

  private byte[] write(McapOptions options) throws IOException {
    Path file = folder.resolve("a.mcap");
    SmallRecording.write(file, options, MESSAGES);
    return Files.readAllBytes(file);
  }

  private List<Chunk> chunks() throws IOException {
    List<Chunk> chunks = new ArrayList<>();
    try (var channel = Files.newByteChannel(folder.resolve("a.mcap"))) {
      RecordStream stream = new RecordStream(channel, Opcode.magic().length);
      for (RecordStream.Entry e = stream.next(); e.opcode() != Opcode.DATA_END; e = stream.next()) {
        if (e.opcode() == Opcode.CHUNK) {
          List<McapMessage> messages = new ArrayList<>();
          for (RecordStream.Entry record : ChunkContent.read(e.fields()).records()) {
            if (record.opcode() == Opcode.MESSAGE) {
              messages.add(McapMessage.read(record.fields()));
            }
          }
          chunks.add(
              new Chunk(e.offset(), e.offset() + e.length(), SmallRecording.texts(messages)));
        }
      }
    }
    assertThat(chunks).hasSizeGreaterThan(3);
    return chunks;
  }

  private static List<String> messages(List<Chunk> chunks, List<Integer> damaged, int end) {
    return chunks.stream()
        .filter(c -> c.to <= end && damaged.stream().noneMatch(at -> at >= c.from && at < c.to))
        .flatMap(c -> c.messages.stream())
        .toList();
  }

  private static void flip(byte[] bytes, int at, Random random) {
    bytes[at] ^= (byte) (1 << random.nextInt(8));
  }

  private McapRecovery.Result recover(byte[] damaged) throws IOException {
    Files.write(broken, damaged);
    Files.deleteIfExists(whole);
    return McapRecovery.recover(broken, whole, "test");
  }

  private void requireTopics() throws IOException {
    try (McapReader reader = McapReader.open(whole)) {
      Map<Integer, String> topics = new TreeMap<>();
      reader.channels().values().forEach(channel -> topics.put(channel.id(), channel.topic()));
      assertThat(topics).isEqualTo(TOPICS);
      assertThat(reader.schemas().get(1).name()).isEqualTo("Thing");
    }
  }

  @ParameterizedTest
  @EnumSource(ChunkCompression.class)
  void recover_bitFlippedInEachByteInTurn_keepsAllOtherChunks(ChunkCompression compression)
      throws IOException {
    byte[] bytes = write(definedOnce(compression));
    List<Chunk> chunks = chunks();
    List<String> written = messages(chunks, List.of(), bytes.length);
    Random random = new Random(5);
    for (int at = 0; at < bytes.length; at++) {
      byte[] damaged = bytes.clone();
      flip(damaged, at, random);
      McapRecovery.Result result = recover(damaged);
      List<String> found = SmallRecording.read(whole);
      assertThat(found)
          .as("byte %d of %d", at, bytes.length)
          .containsAll(messages(chunks, List.of(at), bytes.length))
          .isSubsetOf(written)
          .doesNotHaveDuplicates();
      assertThat(result.trouble()).as("trouble at byte %d", at).isPresent();
      assertThat(result.messages()).isEqualTo(found.size());
      requireTopics();
    }
  }

  @ParameterizedTest
  @EnumSource(ChunkCompression.class)
  void recover_cutAndOneBitFlipped_keepsAllOtherWholeChunks(ChunkCompression compression)
      throws IOException {
    byte[] bytes = write(SmallRecording.options(compression, CHUNK_BYTES));
    List<Chunk> chunks = chunks();
    List<String> written = messages(chunks, List.of(), bytes.length);
    int second = (int) chunks.get(1).to;
    for (int seed = 0; seed < 1_000; seed++) {
      Random random = new Random(seed);
      int cut = second + random.nextInt(bytes.length - second);
      byte[] damaged = Arrays.copyOf(bytes, cut);
      int at = random.nextInt(cut);
      flip(damaged, at, random);
      recover(damaged);
      assertThat(SmallRecording.read(whole))
          .as("seed %d: byte %d, cut after %d of %d", seed, at, cut, bytes.length)
          .containsAll(messages(chunks, List.of(at), cut))
          .doesNotHaveDuplicates();
      assertThat(SmallRecording.read(whole).stream().filter(m -> !written.contains(m)).count())
          .as("seed %d: messages that nobody wrote", seed)
          .isLessThanOrEqualTo(1); // of the last chunk, whose checksum is about more than there is
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2})
  void recover_chunkAndSummaryDamaged_keepsTheOtherChunks(int which) throws IOException {
    byte[] bytes = write(SmallRecording.options(ChunkCompression.LZ4, CHUNK_BYTES));
    List<Chunk> chunks = chunks();
    int inChunk = (int) (chunks.get(which).from + chunks.get(which).to) / 2;
    for (int inSummary = (int) chunks.get(chunks.size() - 1).to; inSummary < bytes.length; ) {
      byte[] damaged = bytes.clone();
      flip(damaged, inChunk, new Random(inSummary));
      flip(damaged, inSummary, new Random(inSummary));
      recover(damaged);
      assertThat(SmallRecording.read(whole))
          .as("bytes %d and %d", inChunk, inSummary)
          .isEqualTo(messages(chunks, List.of(inChunk), bytes.length));
      requireTopics();
      inSummary += 7;
    }
  }

  @Test
  void recover_twoDamagedChunks_countsThem() throws IOException {
    byte[] bytes = write(SmallRecording.options(ChunkCompression.LZ4, CHUNK_BYTES));
    List<Chunk> chunks = chunks();
    for (int which : List.of(0, 2)) {
      int checksum = (int) chunks.get(which).from + Opcode.PREFIX + 8 + 8 + 8;
      bytes[checksum] ^= 1;
    }
    McapRecovery.Result result = recover(bytes);
    assertThat(result.damagedChunks()).isEqualTo(2);
    assertThat(result.trouble().orElseThrow())
        .contains("the chunk at byte " + chunks.get(0).from + ": ");
  }

  @Test
  void recover_endFilledWithZeros_keepsAllWholeChunks() throws IOException {
    byte[] bytes = write(SmallRecording.options(ChunkCompression.LZ4, CHUNK_BYTES));
    List<Chunk> chunks = chunks();
    int from = (int) chunks.get(2).to;
    Arrays.fill(bytes, from, bytes.length, (byte) 0); // as after a power cut
    recover(bytes);
    assertThat(SmallRecording.read(whole)).isEqualTo(messages(chunks, List.of(), from));
  }

  @Test
  void recover_textFile_findsNothingAndSaysWhy() throws IOException {
    McapRecovery.Result result = recover("not a recording ".repeat(1000).getBytes());
    assertThat(result.messages()).isZero();
    assertThat(result.trouble().orElseThrow()).contains("mark MCAP");
  }
}
