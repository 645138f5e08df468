package org.u2sa.recorder.mcap;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.recorder.mcap.record.AttachmentIndex;
import org.u2sa.recorder.mcap.record.ChunkIndex;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapException;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.recorder.mcap.record.McapStatistics;
import org.u2sa.recorder.mcap.record.MetadataIndex;
import org.u2sa.recorder.mcap.record.Opcode;
import org.u2sa.recorder.mcap.record.RecordBuffer;

/** Files made to fill a reader's memory, or to lead it astray. */
class HostileFileTest {
  @TempDir Path folder;

  private Path file() {
    return folder.resolve("hostile.mcap");
  }

  /** A sound recording whose summary lists the indexes that are made of its own ones. */
  private void writeWithIndexes(
      UnaryOperator<List<ChunkIndex>> chunks,
      UnaryOperator<List<AttachmentIndex>> attachments,
      UnaryOperator<List<MetadataIndex>> metadata)
      throws IOException {
    Path sound = folder.resolve("sound.mcap");
    SmallRecording.write(sound, SmallRecording.options(ChunkCompression.LZ4, 500), 50);
    List<ChunkIndex> chunkIndexes = new ArrayList<>();
    List<AttachmentIndex> attachmentIndexes = new ArrayList<>();
    List<MetadataIndex> metadataIndexes = new ArrayList<>();
    McapStatistics statistics;
    long dataEnd = 0;
    try (SeekableByteChannel in = Files.newByteChannel(sound);
        McapReader reader = McapReader.open(sound)) {
      statistics = reader.statistics();
      RecordStream stream = new RecordStream(in, Opcode.magic().length);
      for (RecordStream.Entry e = stream.next(); e.opcode() != Opcode.FOOTER; e = stream.next()) {
        switch (e.opcode()) {
          case Opcode.DATA_END -> dataEnd = e.offset() + e.length();
          case Opcode.CHUNK_INDEX -> chunkIndexes.add(ChunkIndex.read(e.fields()));
          case Opcode.ATTACHMENT_INDEX -> attachmentIndexes.add(AttachmentIndex.read(e.fields()));
          case Opcode.METADATA_INDEX -> metadataIndexes.add(MetadataIndex.read(e.fields()));
          default -> {
            // the rest of the summary is written below
          }
        }
      }
    }
    List<ChunkIndex> written = chunks.apply(chunkIndexes);
    RecordBuffer out = new RecordBuffer(1 << 16, false);
    new McapChannel(1, 0, "topic1", "cbor", Map.of()).write(out);
    new McapStatistics(
            statistics.messages(), 0, 1, 1, 1, written.size(), 0, 1L << 40, Map.of(1, 20L))
        .write(out);
    written.forEach(index -> index.write(out));
    attachments.apply(attachmentIndexes).forEach(index -> index.write(out));
    metadata.apply(metadataIndexes).forEach(index -> index.write(out));
    out.uint8(Opcode.FOOTER).uint64(20).uint64(dataEnd).uint64(0).uint32(0);
    out.bytes(Opcode.magic(), 0, Opcode.magic().length);
    byte[] data = Arrays.copyOf(Files.readAllBytes(sound), (int) dataEnd);
    Files.write(file(), data);
    Files.write(file(), Arrays.copyOf(out.array(), out.length()), StandardOpenOption.APPEND);
  }

  private static <T> UnaryOperator<List<T>> asTheyAre() {
    return UnaryOperator.identity();
  }

  private static <T> List<T> times2000(List<T> indexes) {
    List<T> all = new ArrayList<>();
    for (int i = 0; i < 2_000; i++) {
      all.addAll(indexes);
    }
    return all;
  }

  private void requireRefused(String words) {
    assertThatThrownBy(() -> McapReader.open(file()))
        .isInstanceOf(McapException.class)
        .hasMessageContaining("hostile.mcap")
        .hasMessageContaining(words);
  }

  @Test
  void open_summaryAsItWas_isRead() throws IOException {
    writeWithIndexes(asTheyAre(), asTheyAre(), asTheyAre());
    try (McapReader reader = McapReader.open(file())) {
      assertThat(SmallRecording.read(reader.messages(0, channel -> true))).isNotEmpty();
      assertThat(reader.metadata()).hasSize(1);
      assertThat(reader.attachment("system.xml")).isPresent();
    }
  }

  @Test
  void open_chunkIndexed2000Times_isRefused() throws IOException {
    writeWithIndexes(HostileFileTest::times2000, asTheyAre(), asTheyAre());
    requireRefused("overlapping no other");
  }

  @Test
  void open_attachmentIndexedTwice_isRefused() throws IOException {
    writeWithIndexes(asTheyAre(), all -> List.of(all.get(0), all.get(0)), asTheyAre());
    requireRefused("overlapping no other");
  }

  @Test
  void open_metadataIndexedTwice_isRefused() throws IOException {
    writeWithIndexes(asTheyAre(), asTheyAre(), all -> List.of(all.get(0), all.get(0)));
    requireRefused("overlapping no other");
  }

  @ParameterizedTest
  @ValueSource(longs = {-1, 0, 7, 100_000_000, Long.MAX_VALUE, Long.MIN_VALUE})
  void open_metadataIndexedOutsideOfTheData_isRefused(long offset) throws IOException {
    writeWithIndexes(
        asTheyAre(), asTheyAre(), all -> List.of(new MetadataIndex(offset, 50, "run")));
    requireRefused("the summary names a record at byte");
  }

  @ParameterizedTest
  @ValueSource(longs = {-1, 0, 8, 100_000_000, Long.MAX_VALUE, Long.MIN_VALUE})
  void open_metadataIndexedWithImpossibleLength_isRefused(long length) throws IOException {
    writeWithIndexes(
        asTheyAre(),
        asTheyAre(),
        all -> List.of(new MetadataIndex(all.get(0).offset(), length, "run")));
    requireRefused("the summary names a record at byte");
  }

  @Test
  void metadata_indexedWithAnotherLength_isRefused() throws IOException {
    writeWithIndexes(
        asTheyAre(),
        asTheyAre(),
        all -> List.of(new MetadataIndex(all.get(0).offset(), all.get(0).length() - 1, "run")));
    try (McapReader reader = McapReader.open(file())) {
      assertThatThrownBy(reader::metadata)
          .isInstanceOf(McapException.class)
          .hasMessageContaining("expected kind 12");
    }
  }

  @Test
  void next_chunkIndexedWithAnotherSize_isRefused() throws IOException {
    writeWithIndexes(
        all -> {
          ChunkIndex c = all.get(0);
          return List.of(
              new ChunkIndex(
                  c.startNanos(),
                  c.endNanos(),
                  c.offset(),
                  c.length(),
                  c.messageIndexes(),
                  c.messageIndexLength(),
                  c.compression(),
                  c.compressedSize(),
                  1));
        },
        asTheyAre(),
        asTheyAre());
    try (McapReader reader = McapReader.open(file())) {
      assertThatThrownBy(() -> reader.messages(0, channel -> true).next())
          .isInstanceOf(McapException.class)
          .hasMessageContaining("but the summary 1");
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {8, 16, 36, 44})
  void open_hardlyMoreThanTheMagicBytes_isRefusedInWords(int length) throws IOException {
    byte[] bytes = new byte[length];
    System.arraycopy(Opcode.magic(), 0, bytes, 0, 8);
    System.arraycopy(Opcode.magic(), 0, bytes, length - 8, 8);
    Files.write(file(), bytes);
    requireRefused("too few");
  }

  @Test
  void open_summaryWithoutChunkIndexes_isRefused() throws IOException {
    writeWithIndexes(all -> List.of(), asTheyAre(), asTheyAre());
    requireRefused("lacks the positions of its messages");
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void open_otherMagicBytes_isRefused(boolean atTheEnd) throws IOException {
    writeWithIndexes(asTheyAre(), asTheyAre(), asTheyAre());
    byte[] bytes = Files.readAllBytes(file());
    bytes[atTheEnd ? bytes.length - 3 : 3] ^= 1;
    Files.write(file(), bytes);
    requireRefused("at byte " + (atTheEnd ? bytes.length - 8 : 0) + " the bytes do not mark");
  }

  @ParameterizedTest
  @ValueSource(longs = {0, 8, -5, Long.MAX_VALUE})
  void open_footerAlone_hasNoSummary(long summaryStart) throws IOException {
    RecordBuffer out = new RecordBuffer(100, false);
    out.bytes(Opcode.magic(), 0, 8).uint8(Opcode.FOOTER).uint64(20);
    out.uint64(summaryStart).uint64(0).uint32(0).bytes(Opcode.magic(), 0, 8);
    Files.write(file(), Arrays.copyOf(out.array(), out.length()));
    requireRefused("the file has no summary");
  }

  private static IndexedPlaces places(long... offsetsAndLengths) {
    IndexedPlaces places = new IndexedPlaces();
    for (int i = 0; i < offsetsAndLengths.length; i += 2) {
      places.add(offsetsAndLengths[i], offsetsAndLengths[i + 1]);
    }
    return places;
  }

  @Test
  void require_placesThatFillTheDataInAnyOrder_areRight() throws IOException {
    places(17, 10, 8, 9).require(27);
    places().require(8);
  }

  @Test
  void require_placesOneByteOff_areRefused() {
    for (IndexedPlaces wrong :
        List.of(
            places(8, 8),
            places(7, 9),
            places(8, 20),
            places(8, 9, 16, 9),
            places(19, 9),
            places(28, 9),
            places(8, Long.MAX_VALUE))) {
      assertThatThrownBy(() -> wrong.require(27))
          .isInstanceOf(McapException.class)
          .hasMessageContaining("between bytes");
    }
  }

  private static ChunkIndex of(int number, long endNanos, Map<Integer, Long> channels) {
    return new ChunkIndex(0, endNanos, number, 10, channels, 0, "", 100, 100);
  }

  private static byte[] messages(long size, long nanos) {
    RecordBuffer out = new RecordBuffer(100, false);
    int data = (int) size - Opcode.PREFIX - McapMessage.FIXED;
    new McapMessage(1, 0, nanos, nanos, new byte[data]).write(out);
    return Arrays.copyOf(out.array(), out.length());
  }
}
