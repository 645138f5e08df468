package org.u2sa.recorder.playback;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.messages.StateInformation;
import org.u2sa.recorder.mcap.ChunkCompression;
import org.u2sa.recorder.mcap.McapOptions;
import org.u2sa.recorder.mcap.McapWriter;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapMessage;

class RecordedMessagesTest {
  @TempDir Path folder;

  @Test
  void open_channelWithAnEmptyTopic_isLeftOutAndSaid() throws IOException {
    Path file = folder.resolve("foreign.mcap");
    try (McapWriter writer =
        new McapWriter(
            FileChannel.open(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE),
            McapOptions.usual(ChunkCompression.LZ4, "test"))) {
      writer.add(new McapChannel(1, 0, "", "cbor", Map.of()));
      writer.add(new McapChannel(2, 0, "u2sa/a/state/StateInformation", "cbor", Map.of()));
      byte[] state = new StateInformation().psi(1.0).serialize();
      writer.add(new McapMessage(1, 0, 0, 0, state));
      writer.add(new McapMessage(2, 0, 1, 1, state));
    }
    List<String> channels = new ArrayList<>();
    try (RecordedMessages recording = RecordedMessages.open(file).requireMessages()) {
      recording.forEach(
          recording.channels(List.of()),
          RecordedSpan.all(recording.reader()),
          (topic, message, nanos) -> channels.add(topic.channel()));
      assertThat(recording.undecodable().orElseThrow())
          .startsWith(
              "channels left out for their topics: 1, the first: topic \"\": expected u2sa");
    }
    assertThat(channels).containsExactly("state");
  }

  @Test
  void undecodable_recordingReadTwice_countsEachMessageOnce() throws IOException {
    Path file = folder.resolve("damaged.mcap");
    try (McapWriter writer =
        new McapWriter(
            FileChannel.open(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE),
            McapOptions.usual(ChunkCompression.LZ4, "test"))) {
      writer.add(new McapChannel(1, 0, "u2sa/a/state/StateInformation", "cbor", Map.of()));
      writer.add(new McapChannel(2, 0, "u2sa/a/goals/GoalList", "cbor", Map.of()));
      writer.add(new McapMessage(1, 0, 0, 0, new byte[] {1}));
      writer.add(new McapMessage(2, 0, 1, 1, new byte[] {1}));
      writer.add(new McapMessage(2, 1, 2, 2, new byte[] {1}));
    }
    try (RecordedMessages recording = RecordedMessages.open(file)) {
      for (List<String> channels : List.of(List.of("state"), List.of("goals"), List.<String>of())) {
        recording.forEach(
            recording.channels(channels),
            RecordedSpan.all(recording.reader()),
            (topic, message, nanos) -> {});
      }
      assertThat(recording.undecodable().orElseThrow())
          .startsWith("messages that cannot be decoded: 3, the first on u2sa/a/state/");
    }
  }
}
