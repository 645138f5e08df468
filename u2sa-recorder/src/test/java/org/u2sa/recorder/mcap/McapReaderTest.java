package org.u2sa.recorder.mcap;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapException;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.recorder.mcap.record.McapMetadata;

class McapReaderTest {
  private static final int SEVERAL = 500;
  private static final int SMALL_CHUNKS = 1000;

  @TempDir Path folder;

  @ParameterizedTest
  @EnumSource(ChunkCompression.class)
  void messages_ofManyChunks_areThoseWritten(ChunkCompression compression) throws IOException {
    Path file = folder.resolve("a.mcap");
    List<McapMessage> written =
        SmallRecording.write(file, SmallRecording.options(compression, SMALL_CHUNKS), SEVERAL);
    assertThat(SmallRecording.read(file)).isEqualTo(SmallRecording.texts(written));
    try (McapReader reader = McapReader.open(file)) {
      assertThat(reader.statistics().chunks()).isGreaterThan(20);
      assertThat(reader.statistics().messages()).isEqualTo(SEVERAL);
      assertThat(reader.statistics().messagesByChannel()).containsEntry(1, 167L);
      assertThat(reader.attachmentNames()).containsExactly("system.xml");
      assertThat(reader.attachment("system.xml").orElseThrow().data()).containsExactly(1, 2, 3);
      assertThat(reader.attachment("other")).isEmpty();
      assertThat(reader.metadata()).containsExactly(new McapMetadata("run", Map.of("seed", "1")));
      assertThat(reader.schemas().get(1).name()).isEqualTo("Thing");
    }
  }

  @Test
  void attachment_lengthBeyondItsRecord_isRefusedWithFileAndPlace() throws IOException {
    Path file = folder.resolve("a.mcap");
    SmallRecording.write(file, SmallRecording.options(ChunkCompression.LZ4, SMALL_CHUNKS), SEVERAL);
    byte[] bytes = Files.readAllBytes(file);
    int name = new String(bytes, ISO_8859_1).indexOf("system.xml"); // its record, then the index
    bytes[name - 1] = 7; // most significant byte of the length
    Files.write(file, bytes);
    try (McapReader reader = McapReader.open(file)) {
      assertThatThrownBy(() -> reader.attachment("system.xml"))
          .isInstanceOf(McapException.class)
          .hasMessageStartingWith(file + ": the record at byte ")
          .hasMessageEndingWith("recover the file first");
    }
  }

  @Test
  void open_fileOfAnotherKind_saysWhatIsExpected() throws IOException {
    Path file = Files.writeString(folder.resolve("a.log"), "FLASER 180 1.0 2.0 3.0\n".repeat(9));
    assertThatThrownBy(() -> McapReader.open(file))
        .isInstanceOf(McapException.class)
        .hasMessageStartingWith(file + ": at byte 0")
        .hasMessageEndingWith("expected an MCAP file; recover it if it was one");
  }

  @Test
  void channels_askedForWithEachMessage_areNotCopied() throws IOException {
    Path file = folder.resolve("a.mcap");
    SmallRecording.write(file, SmallRecording.options(ChunkCompression.LZ4, SMALL_CHUNKS), SEVERAL);
    try (McapReader reader = McapReader.open(file)) {
      assertThat(reader.channels()).isSameAs(reader.channels());
      assertThat(reader.schemas()).isSameAs(reader.schemas());
      assertThatThrownBy(() -> reader.channels().clear())
          .isInstanceOf(UnsupportedOperationException.class);
    }
  }

  @Test
  void messages_fromATimeOfOneChannel_areTheRestOfThatChannel() throws IOException {
    Path file = folder.resolve("a.mcap");
    List<McapMessage> written =
        SmallRecording.write(
            file, SmallRecording.options(ChunkCompression.LZ4, SMALL_CHUNKS), SEVERAL);
    try (McapReader reader = McapReader.open(file)) {
      for (int first = 180; first < 220; first++) { // over a chunk's beginning and its middle
        List<McapMessage> read =
            SmallRecording.read(
                reader.messages(
                    written.get(first).logTimeNanos(),
                    channel -> channel.topic().equals("topic2")));
        assertThat(SmallRecording.texts(read))
            .as("from message %d", first)
            .isEqualTo(
                SmallRecording.texts(
                    written.subList(first, SEVERAL).stream()
                        .filter(message -> message.channelId() == 2)
                        .toList()));
      }
    }
  }

  @Test
  void messages_ofEqualTimesInTwoChunks_comeInTheFilesOrder() throws IOException {
    Path file = folder.resolve("a.mcap");
    try (McapWriter writer =
        new McapWriter(
            FileChannel.open(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE),
            SmallRecording.options(ChunkCompression.NONE, 1 << 20))) {
      writer.add(new McapChannel(1, 0, "t", "cbor", Map.of()));
      writer.add(new McapMessage(1, 0, 5, 5, new byte[0]));
      writer.flush();
      writer.add(new McapMessage(1, 1, 3, 3, new byte[0]));
      writer.add(new McapMessage(1, 2, 5, 5, new byte[0]));
    }
    try (McapReader reader = McapReader.open(file)) {
      assertThat(SmallRecording.read(reader.messages(0, channel -> true)))
          .extracting(McapMessage::sequence)
          .containsExactly(1L, 0L, 2L);
    }
  }

  @Test
  void messages_ofChunksThatOverlapInTime_comeInTheOrderOfTime() throws IOException {
    Path file = folder.resolve("a.mcap");
    long[] times = {5, 1, 9, 3, 8, 2, 2, 7};
    try (McapWriter writer =
        new McapWriter(
            FileChannel.open(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE),
            SmallRecording.options(ChunkCompression.NONE, 1))) {
      writer.add(new McapChannel(1, 0, "t", "cbor", Map.of()));
      for (int i = 0; i < times.length; i++) {
        writer.add(new McapMessage(1, i, times[i], times[i], new byte[0]));
      }
    }
    try (McapReader reader = McapReader.open(file)) {
      List<McapMessage> read = SmallRecording.read(reader.messages(2, channel -> true));
      assertThat(read)
          .extracting(McapMessage::logTimeNanos)
          .containsExactly(2L, 2L, 3L, 5L, 7L, 8L, 9L);
      assertThat(read).extracting(McapMessage::sequence).startsWith(5L, 6L); // as in the file
    }
  }

  @Test
  void open_fileThatBreaksOff_saysThatItCanBeRecovered() throws IOException {
    Path file = folder.resolve("a.mcap");
    SmallRecording.write(file, SmallRecording.options(ChunkCompression.LZ4, SMALL_CHUNKS), 50);
    byte[] bytes = Files.readAllBytes(file);
    Files.write(file, java.util.Arrays.copyOf(bytes, bytes.length - 3));
    assertThatThrownBy(() -> McapReader.open(file))
        .isInstanceOf(McapException.class)
        .hasMessageContaining("a.mcap")
        .hasMessageContaining("recover");
  }

  @Test
  void next_chunkWithOneByteChanged_isRefused() throws IOException {
    Path file = folder.resolve("a.mcap");
    SmallRecording.write(file, SmallRecording.options(ChunkCompression.NONE, 1 << 20), 50);
    byte[] bytes = Files.readAllBytes(file);
    bytes[bytes.length / 3] ^= 1; // within the messages of the only chunk
    Files.write(file, bytes);
    try (McapReader reader = McapReader.open(file)) {
      assertThatThrownBy(() -> reader.messages(0, channel -> true).next())
          .isInstanceOf(McapException.class)
          .hasMessageContaining("a.mcap: the chunk at byte")
          .hasMessageContaining("checksum")
          .hasMessageContaining("recover");
    }
  }
}
