package org.u2sa.recorder.playback;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.recorder.mcap.ChunkCompression;
import org.u2sa.recorder.mcap.McapOptions;
import org.u2sa.recorder.mcap.McapWriter;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.recorder.mcap.record.McapSchema;

class RetainedHistoryTest {
  private static final int GRID = 1;
  private static final int GOALS = 2;
  private static final int STATE = 3;

  @TempDir private Path folder;

  private RecordedMessages recording(Map<Integer, Long> last, int grids, int bytes)
      throws IOException {
    Path file = folder.resolve("retained.mcap");
    try (McapWriter writer =
        new McapWriter(
            FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE),
            McapOptions.usual(ChunkCompression.LZ4, "test"))) {
      writer.add(new McapSchema(1, "Any", "", new byte[0]));
      writer.add(new McapChannel(GRID, 1, "u2sa/a/grid/OccupancyGrid", "cbor", Map.of()));
      writer.add(new McapChannel(GOALS, 1, "u2sa/a/goals/GoalList", "cbor", Map.of()));
      writer.add(new McapChannel(STATE, 1, "u2sa/a/state/StateInformation", "cbor", Map.of()));
      for (int i = 0; i < grids; i++) {
        byte[] content = new byte[bytes];
        content[0] = (byte) i;
        writer.add(new McapMessage(GRID, i, i, i, content));
        writer.add(new McapMessage(STATE, i, i, i, new byte[1]));
      }
      for (Map.Entry<Integer, Long> each : last.entrySet()) {
        byte[] content = {each.getKey().byteValue()};
        writer.add(new McapMessage(GOALS, 0, each.getValue(), each.getValue(), content));
      }
    }
    return RecordedMessages.open(file);
  }

  private static Map<Integer, Integer> newest(RetainedHistory history, long nanos)
      throws IOException {
    Map<Integer, Integer> found = new TreeMap<>();
    for (McapMessage each : history.before(nanos)) {
      found.put(each.channelId(), (int) each.data()[0]);
    }
    return found;
  }

  @Test
  void before_aTime_theLastOfEachRetainedTopicAndNothingElse() throws IOException {
    try (RecordedMessages recording = recording(new TreeMap<>(Map.of(7, 5L, 8, 5L)), 10, 1)) {
      RetainedHistory history = new RetainedHistory(recording);

      assertThat(newest(history, 0)).isEmpty();
      assertThat(newest(history, 5)).isEqualTo(Map.of(GRID, 4));
      assertThat(newest(history, 6)).isEqualTo(Map.of(GRID, 5, GOALS, 8));
      assertThat(newest(history, Long.MAX_VALUE)).isEqualTo(Map.of(GRID, 9, GOALS, 8));
    }
  }

  @Test
  void before_largeMaps_areNotHeld() throws IOException {
    try (RecordedMessages recording = recording(Map.of(), 60, 500_000)) {
      long before = used();
      RetainedHistory history = new RetainedHistory(recording);
      assertThat(used() - before).as("of 30 MB").isLessThan(10_000_000L);
      assertThat(history.before(50)).hasSize(1);
    }
  }

  private static long used() {
    System.gc();
    Runtime runtime = Runtime.getRuntime();
    return runtime.totalMemory() - runtime.freeMemory();
  }
}
