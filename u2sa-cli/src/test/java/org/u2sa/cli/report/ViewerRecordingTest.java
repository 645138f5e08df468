package org.u2sa.cli.report;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.CommandFixture;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.PathStatus;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.frame.Point;
import org.u2sa.recorder.SchemaText;
import org.u2sa.recorder.mcap.ChunkCompression;
import org.u2sa.recorder.mcap.McapCursor;
import org.u2sa.recorder.mcap.McapOptions;
import org.u2sa.recorder.mcap.McapReader;
import org.u2sa.recorder.mcap.McapWriter;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.recorder.mcap.record.McapSchema;

/** A recording of one planned path, its view, and an execution. */
class ViewerRecordingTest extends CommandFixture {
  private static final byte[] VIEW = {1, 2, 3};
  private static final String TOPIC =
      Topic.of("rover", Channels.PLANS, new PlannedPath()).toString();

  @TempDir private Path folder;
  private Path recording;

  @BeforeEach
  void write() throws IOException {
    recording = folder.resolve("run.mcap");
    PlannedPath path =
        new PlannedPath()
            .planner("PathPlanner")
            .status(PathStatus.FOLLOWED)
            .points(List.of(new Point(1.5, 2.0, 0.0)));
    try (McapWriter writer =
        new McapWriter(
            Files.newByteChannel(recording, StandardOpenOption.CREATE, StandardOpenOption.WRITE),
            McapOptions.usual(ChunkCompression.LZ4, "test"))) {
      byte[] schema = SchemaText.of(path.type()).getBytes(StandardCharsets.UTF_8);
      writer.add(new McapSchema(1, "PlannedPath", "jsonschema", schema));
      writer.add(new McapSchema(2, "foxglove.SceneUpdate", "protobuf", VIEW));
      writer.add(new McapChannel(1, 1, TOPIC, "cbor", Map.of("channel", "plans")));
      writer.add(new McapChannel(2, 2, "/rover/plan", "protobuf", Map.of()));
      writer.add(new McapChannel(3, 0, "execution/PathPlanner", "u2sa-execution", Map.of()));
      writer.add(new McapMessage(1, 7, 1_000, 900, path.serialize()));
      writer.add(new McapMessage(2, 0, 1_000, 900, VIEW));
      writer.add(new McapMessage(3, 0, 1_000, 900, VIEW));
    }
  }

  private int export(String... more) {
    List<String> all = new ArrayList<>(List.of("export", recording.toString(), "--format", "mcap"));
    all.addAll(List.of(more));
    return u2sa(all.toArray(new String[0]));
  }

  private static List<McapMessage> messages(McapReader reader) throws IOException {
    List<McapMessage> messages = new ArrayList<>();
    McapCursor cursor = reader.messages(Long.MIN_VALUE, channel -> true);
    for (Optional<McapMessage> m = cursor.next(); m.isPresent(); m = cursor.next()) {
      messages.add(m.get());
    }
    return messages;
  }

  @Test
  void mcap_messageAndView_areJsonAndAsTheyWere() throws IOException {
    assertThat(export()).as(err.toString()).isEqualTo(ExitCode.DONE);
    try (McapReader reader = McapReader.open(folder.resolve("run-viewer.mcap"))) {
      assertThat(reader.channels().values())
          .extracting(channel -> channel.topic() + " " + channel.messageEncoding())
          .containsExactlyInAnyOrder(TOPIC + " json", "/rover/plan protobuf");
      List<McapMessage> messages = messages(reader);
      assertThat(messages).hasSize(2);
      assertThat(messages.get(0))
          .extracting(McapMessage::sequence, McapMessage::logTimeNanos)
          .containsExactly(7L, 1_000L);
      JsonNode point = new ObjectMapper().readTree(messages.get(0).data()).get("points").get(0);
      assertThat(point.toString()).isEqualTo("{\"x\":1.5,\"y\":2.0,\"z\":0.0}");
      assertThat(messages.get(1).data()).isEqualTo(VIEW);
      JsonNode schema = new ObjectMapper().readTree(reader.schemas().get(1).data());
      assertThat(schema.at("/properties/points/items/properties/y/type").asText())
          .isEqualTo("number");
      assertThat(reader.schemas().get(2).data()).isEqualTo(VIEW);
    }
  }

  @Test
  void mcap_channelNamed_leavesTheRestOut() throws IOException {
    assertThat(export("--channel", "plans")).as(err.toString()).isEqualTo(ExitCode.DONE);
    try (McapReader reader = McapReader.open(folder.resolve("run-viewer.mcap"))) {
      assertThat(messages(reader)).hasSize(1);
    }
  }

  @Test
  void mcap_json_saysFileAndMessages() throws IOException {
    assertThat(export("--json")).as(err.toString()).isEqualTo(ExitCode.DONE);
    JsonNode said = new ObjectMapper().readTree(out.toString());
    assertThat(said.get("file").asText()).endsWith("run-viewer.mcap");
    assertThat(said.get("messages").asLong()).isEqualTo(2);
  }

  @Test
  void mcap_ontoTheRecording_isRefusedAndLeavesIt() throws IOException {
    byte[] before = Files.readAllBytes(recording);
    assertThat(export("--out", recording.toString())).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("is a recording; expected another file");
    assertThat(Files.readAllBytes(recording)).isEqualTo(before);
  }

  @Test
  void mcap_ontoAnotherRecording_isRefusedAndLeavesIt() throws IOException {
    Path other = Files.copy(recording, folder.resolve("other.mcap"));
    assertThat(export("--out", other.toString())).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("other.mcap is a recording");
    assertThat(Files.readAllBytes(other)).isEqualTo(Files.readAllBytes(recording));
  }

  @Test
  void mcap_ontoARecordingThatWasCutOff_isRefusedAndLeavesIt() throws IOException {
    byte[] cut = Arrays.copyOf(Files.readAllBytes(recording), 100);
    Path other = Files.write(folder.resolve("other.mcap"), cut);
    assertThat(export("--out", other.toString())).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(Files.readAllBytes(other)).isEqualTo(cut);
  }

  @Test
  void mcap_ontoAnEarlierExport_replacesIt() {
    assertThat(export()).isEqualTo(ExitCode.DONE);
    assertThat(export()).as(err.toString()).isEqualTo(ExitCode.DONE);
  }
}
