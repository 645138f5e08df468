package org.u2sa.cli.record;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.CommandFixture;
import org.u2sa.cli.Main;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.mission.StandingRover;
import org.u2sa.cli.remote.ForeignSystem;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.mcap.ChunkCompression;
import org.u2sa.recorder.mcap.McapCursor;
import org.u2sa.recorder.mcap.McapOptions;
import org.u2sa.recorder.mcap.McapReader;
import org.u2sa.recorder.mcap.McapWriter;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.recorder.mcap.record.McapMetadata;

/** {@code u2sa record}, {@code recover} and {@code replay} beside a system of another process. */
@Timeout(180)
class RecordCommandsTest extends CommandFixture {
  private static final String STATE = "u2sa/rover/state/StateInformation";

  @TempDir private static Path directory;
  private static ForeignSystem foreign;
  private static Path recording;

  @BeforeAll
  static void start() {
    foreign = ForeignSystem.start(directory, "rover", StandingRover.class.getName());
    recording = directory.resolve("recording.mcap");
    StringWriter said = new StringWriter();
    int code =
        Main.run(
            new PrintWriter(said),
            new PrintWriter(said),
            "record",
            "--broker",
            foreign.broker(),
            "--timeout",
            "60",
            "--for",
            "4",
            "--out",
            recording.toString());
    assertThat(code).as(said.toString()).isEqualTo(ExitCode.DONE);
    assertThat(said.toString()).contains("Recording system rover").contains("recording.mcap");
  }

  @AfterAll
  static void end() {
    foreign.close();
  }

  private static List<byte[]> states(Path file) throws IOException {
    List<byte[]> all = new ArrayList<>();
    try (McapReader reader = McapReader.open(file)) {
      McapCursor cursor = reader.messages(Long.MIN_VALUE, channel -> channel.topic().equals(STATE));
      for (Optional<McapMessage> m = cursor.next(); m.isPresent(); m = cursor.next()) {
        all.add(m.get().data());
      }
    }
    return all;
  }

  @Test
  void record_runningSystem_hasItsMessagesAndFacts() throws IOException {
    assertThat(states(recording)).isNotEmpty();
    try (McapReader reader = McapReader.open(recording)) {
      assertThat(reader.channels().values())
          .anyMatch(channel -> channel.topic().equals("u2sa/rover/health/HealthReport"))
          .anyMatch(channel -> channel.topic().equals("/rover/location"));
      assertThat(reader.metadata())
          .anySatisfy(metadata -> assertThat(metadata.entries()).containsEntry("system", "rover"));
    }
  }

  @Test
  void recover_recordingCutOff_hasTheMessagesBefore() throws IOException {
    Path broken = directory.resolve("broken.mcap");
    byte[] bytes = Files.readAllBytes(recording);
    Files.write(broken, Arrays.copyOf(bytes, bytes.length / 2));
    int code = u2sa("recover", broken.toString());
    assertThat(code).as(err.toString()).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("breaks off").contains("broken-recovered.mcap");
    List<byte[]> before = states(recording);
    List<byte[]> found = states(directory.resolve("broken-recovered.mcap"));
    assertThat(found).isNotEmpty().hasSizeLessThan(before.size());
    for (int i = 0; i < found.size(); i++) {
      assertThat(found.get(i)).isEqualTo(before.get(i));
    }
  }

  @Test
  void recover_json_saysHowManyAndWhatWasWrong() throws IOException {
    Path broken = directory.resolve("cut.mcap");
    byte[] bytes = Files.readAllBytes(recording);
    Files.write(broken, Arrays.copyOf(bytes, bytes.length / 2));
    assertThat(u2sa("recover", broken.toString(), "--json")).isEqualTo(ExitCode.DONE);
    JsonNode said = new ObjectMapper().readTree(out.toString());
    assertThat(said.get("messages").asLong()).isPositive();
    assertThat(said.get("trouble").asText()).contains("breaks off");
    assertThat(Path.of(said.get("file").asText())).isRegularFile();
  }

  @Test
  void recover_nothingReadable_failsAndLeavesNoFile() throws IOException {
    Path text = Files.writeString(directory.resolve("text.mcap"), "not a recording ".repeat(99));
    assertThat(u2sa("recover", text.toString())).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("text.mcap: no message can be recovered");
    assertThat(directory.resolve("text-recovered.mcap")).doesNotExist();
  }

  @Test
  void recover_undamagedWithoutAMessage_failsAndLeavesNoFile() throws IOException {
    Path empty = directory.resolve("empty.mcap");
    try (FileChannel to =
            FileChannel.open(empty, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
        McapWriter writer = new McapWriter(to, McapOptions.usual(ChunkCompression.LZ4, "test"))) {
      writer.add(new McapMetadata("nothing", Map.of("else", "here")));
    }
    assertThat(u2sa("recover", empty.toString())).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString())
        .contains("empty.mcap: no message can be recovered: it contains none");
    assertThat(directory.resolve("empty-recovered.mcap")).doesNotExist();
  }

  @Test
  void recover_noSuchFile_saysSo() {
    assertThat(u2sa("recover", directory.resolve("none.mcap").toString()))
        .isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("none.mcap").contains("no such file");
  }

  @Test
  void replay_oneChannelUnderAnotherId_publishesItsMessagesInOrder() throws Exception {
    BlockingQueue<U2SAData> heard = new LinkedBlockingQueue<>();
    MqttTransport ghost =
        new MqttTransport(
            "127.0.0.1", foreign.port(), "ghost", new MessageCodec(MessageTypes.discovered()));
    try (Connection ear = ghost.connect("Ear", new Ear(heard))) {
      assertThat(ear.subscribe(Channels.STATE)).isTrue();
      int code =
          u2sa(
              "replay",
              recording.toString(),
              "--broker",
              foreign.broker(),
              "--system",
              "ghost",
              "--channel",
              "state",
              "--rate",
              "4");
      assertThat(code).as(err.toString()).isEqualTo(ExitCode.DONE);
      List<byte[]> recorded = states(recording);
      assertThat(out.toString()).contains(recorded.size() + " messages published");
      MessageCodec codec = new MessageCodec(MessageTypes.discovered());
      for (byte[] bytes : recorded) {
        U2SAData next = heard.poll(60, TimeUnit.SECONDS);
        assertThat(next).isEqualTo(codec.decode(List.of("StateInformation"), bytes));
      }
    }
  }

  @Test
  void replay_channelThatWasNotRecorded_isRefusedWithThoseThatWere() {
    int code =
        u2sa("replay", recording.toString(), "--broker", foreign.broker(), "--channel", "stat");
    assertThat(code).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("stat").contains("state");
  }

  /** Keeps what it hears. */
  private record Ear(BlockingQueue<U2SAData> heard) implements Receiver {
    @Override
    public void receive(Channel<?> channel, U2SAData message) {
      heard.add(message);
    }

    @Override
    public void trouble(String what) {
      throw new IllegalStateException(what);
    }
  }
}
