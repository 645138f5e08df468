package org.u2sa.recorder.mcap;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.recorder.mcap.record.ChunkIndex;
import org.u2sa.recorder.mcap.record.McapException;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.recorder.mcap.record.Opcode;
import org.u2sa.recorder.mcap.record.RecordBuffer;

/** Chunks whose indexes would fill the memory of a cursor, or lead it astray. */
class HostileCursorTest {

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

  private static ChunkContent chunk(byte[] records, long size, long crc) {
    return new ChunkContent(size, crc, ChunkCompression.NONE, records);
  }
}
