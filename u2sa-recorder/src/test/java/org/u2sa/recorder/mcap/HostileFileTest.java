package org.u2sa.recorder.mcap;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import java.util.zip.CRC32;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.recorder.mcap.record.AttachmentIndex;
import org.u2sa.recorder.mcap.record.ChunkIndex;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapException;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.recorder.mcap.record.McapMetadata;
import org.u2sa.recorder.mcap.record.McapStatistics;
import org.u2sa.recorder.mcap.record.MetadataIndex;
import org.u2sa.recorder.mcap.record.Opcode;
import org.u2sa.recorder.mcap.record.RecordBuffer;
import org.u2sa.recorder.mcap.record.RecordFields;

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

  @Test
  void next_chunksWithoutWantedMessages_areNotLoaded() throws IOException {
    List<Long> loaded = new ArrayList<>();
    BitSet wanted = new BitSet();
    wanted.set(1);
    McapCursor cursor =
        new McapCursor(
            "a.mcap",
            List.of(
                of(1, 4, Map.of()),
                of(2, 5, Map.of()),
                of(3, 9, Map.of(2, 0L)),
                of(4, 9, Map.of(1, 0L))),
            5,
            wanted,
            chunk -> {
              loaded.add(chunk.offset());
              return new byte[0];
            },
            1_000);
    assertThat(cursor.next()).isEmpty();
    assertThat(loaded).containsExactly(2L, 4L);
  }

  @Test
  void next_messagesOfAChunkOutOfOrder_comeInTheOrderOfTime() throws IOException {
    BitSet wanted = new BitSet();
    wanted.set(1);
    RecordBuffer out = new RecordBuffer(100, false);
    for (long nanos : new long[] {3, 1, 2}) {
      new McapMessage(1, 0, nanos, nanos, new byte[0]).write(out);
    }
    McapCursor cursor =
        new McapCursor(
            "a.mcap",
            List.of(chunk(1, 0, 100)),
            0,
            wanted,
            chunk -> Arrays.copyOf(out.array(), out.length()),
            1_000);
    assertThat(SmallRecording.read(cursor))
        .extracting(McapMessage::logTimeNanos)
        .containsExactly(1L, 2L, 3L);
  }

  private static ChunkIndex chunk(int number, long startNanos, long size) {
    return new ChunkIndex(startNanos, 1_000, number, 10, Map.of(), 0, "", size, size);
  }

  private static byte[] messages(long size, long nanos) {
    RecordBuffer out = new RecordBuffer(100, false);
    int data = (int) size - Opcode.PREFIX - McapMessage.FIXED;
    new McapMessage(1, 0, nanos, nanos, new byte[data]).write(out);
    return Arrays.copyOf(out.array(), out.length());
  }

  private static McapCursor cursor(List<ChunkIndex> chunks, long maxHeldBytes) {
    BitSet wanted = new BitSet();
    wanted.set(1);
    return new McapCursor(
        "a.mcap",
        chunks,
        0,
        wanted,
        chunk -> messages(chunk.size(), chunk.startNanos()),
        maxHeldBytes);
  }

  @Test
  void next_moreChunksAtATimeThanMayBeHeld_isRefused() {
    List<ChunkIndex> chunks = List.of(chunk(1, 0, 100), chunk(2, 0, 100), chunk(3, 0, 101));
    assertThatThrownBy(() -> cursor(chunks, 300).next())
        .isInstanceOf(McapException.class)
        .hasMessageContaining("a chunk of 101 bytes")
        .hasMessageContaining("chunks of 200 bytes");
  }

  @Test
  void next_asManyChunksAsMayBeHeld_areRead() throws IOException {
    List<ChunkIndex> chunks = List.of(chunk(1, 0, 100), chunk(2, 0, 100), chunk(3, 0, 100));
    assertThat(SmallRecording.read(cursor(chunks, 300))).hasSize(3);
  }

  @Test
  void next_chunksOneAfterTheOther_areHeldOneAtATime() throws IOException {
    List<ChunkIndex> chunks = new ArrayList<>();
    for (int i = 0; i < 50; i++) {
      chunks.add(chunk(i, 10L * i, 100));
    }
    assertThat(SmallRecording.read(cursor(chunks, 200))).hasSize(50);
  }

  @ParameterizedTest
  @ValueSource(longs = {-1, Long.MIN_VALUE, 301})
  void next_chunkOfImpossibleSize_isRefused(long size) {
    assertThatThrownBy(() -> cursor(List.of(chunk(1, 0, size)), 300).next())
        .isInstanceOf(McapException.class)
        .hasMessageContaining("a chunk of " + size + " bytes");
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
