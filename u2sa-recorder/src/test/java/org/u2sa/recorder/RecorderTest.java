package org.u2sa.recorder;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.contract.ConfigurationRequest;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.mcap.McapCursor;
import org.u2sa.recorder.mcap.McapReader;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.recorder.mcap.record.McapMetadata;
import org.u2sa.service.ServiceContext;

class RecorderTest {
  private static final Channel<StateInformation> OWN =
      Channel.every("own-channel", StateInformation.TYPE);

  @TempDir Path folder;

  private final LocalBus bus = new LocalBus("rover");
  private final Connection publisher = bus.connect("Publisher", new Silent());

  /** Receives nothing. */
  static final class Silent implements Receiver {
    @Override
    public void receive(Channel<?> channel, U2SAData message) {
      throw new IllegalStateException("subscribed to nothing");
    }

    @Override
    public void trouble(String what) {
      throw new IllegalStateException(what);
    }
  }

  private ServiceContext context(Map<String, Object> values) {
    return ServiceContext.of("rover", XmlConfiguration.inMemory("Recorder", values))
        .transport(bus)
        .logDirectory(folder)
        .seed(5)
        .build();
  }

  private static StateInformation state(double x) {
    return new StateInformation().sensorName("gps").x(x).y(48.0).z(400.0).psi(0.5);
  }

  private <T extends U2SAData> T publish(Channel<?> channel, T message) {
    message.systemId("rover");
    message.timestamp(1_000);
    message.freeze();
    assertThat(publisher.publish(channel, message)).isTrue();
    return message;
  }

  /** Messages by topic. */
  private static Map<String, List<byte[]>> read(Path file) throws IOException {
    Map<String, List<byte[]>> all = new TreeMap<>();
    try (McapReader reader = McapReader.open(file)) {
      McapCursor cursor = reader.messages(Long.MIN_VALUE, channel -> true);
      for (Optional<McapMessage> m = cursor.next(); m.isPresent(); m = cursor.next()) {
        McapChannel channel = reader.channels().get(m.get().channelId());
        all.computeIfAbsent(channel.topic(), topic -> new ArrayList<>()).add(m.get().data());
      }
    }
    return all;
  }

  @Test
  void record_messagesOfSeveralChannels_areInTheFileByteForByte() throws IOException {
    Recorder recorder = new Recorder(context(Map.of()));
    StateInformation first = publish(Channels.STATE, state(11.0));
    StateInformation second = publish(Channels.STATE, state(11.1));
    U2SAData command =
        publish(Channels.ACTUATION, new PercentageCommand().actuatorName("LEFT").percentage(50.0));
    U2SAData announced =
        publish(
            Channels.ACTUATORS,
            new ActuatorAnnouncement().actuatorName("LEFT").minimum(-100.0).maximum(100.0));
    StateInformation own = publish(OWN, state(12.0));
    recorder.kill();
    Map<String, List<byte[]>> read = read(folder.resolve("recording.mcap"));
    assertThat(read.get("u2sa/rover/state/StateInformation"))
        .containsExactly(first.serialize(), second.serialize());
    assertThat(read.get("u2sa/rover/actuation/ActuatorCommand/PercentageCommand"))
        .containsExactly(command.serialize());
    assertThat(read.get("u2sa/rover/actuators/ActuatorAnnouncement/=LEFT"))
        .containsExactly(announced.serialize());
    assertThat(read.get("u2sa/rover/own-channel/StateInformation"))
        .containsExactly(own.serialize());
    assertThat(read.get("/rover/pose")).hasSize(2);
    assertThat(read.get("/rover/location")).hasSize(2);
    assertThat(recorder.messages()).isEqualTo(5);
  }

  @Test
  void record_fromAnotherProcess_isInTheFile() throws IOException {
    Recorder recorder = new Recorder(context(Map.of("FORM", "U2SA")));
    ConfigurationRequest request = new ConfigurationRequest().serviceName("Planner");
    request.systemId("rover");
    request.freeze();
    bus.deliver(Channels.CONFIGURATION, request);
    recorder.kill();
    assertThat(read(folder.resolve("recording.mcap")))
        .containsOnlyKeys("u2sa/rover/configuration/" + String.join("/", request.typeChain()));
  }

  @Test
  void record_timeSchemaAndSequence_areSaid() throws Exception {
    Recorder recorder = new Recorder(context(Map.of("FORM", "U2SA")));
    publish(Channels.STATE, state(11.0));
    publish(Channels.STATE, state(11.1));
    recorder.kill();
    try (McapReader reader = McapReader.open(folder.resolve("recording.mcap"))) {
      McapCursor cursor = reader.messages(0, channel -> true);
      McapMessage message = cursor.next().orElseThrow();
      assertThat(message.publishTimeNanos()).isEqualTo(1_000_000);
      assertThat(message.logTimeNanos()).isGreaterThan(1_700_000_000_000_000_000L);
      assertThat(message.sequence()).isZero();
      assertThat(cursor.next().orElseThrow().sequence()).isEqualTo(1);
      McapChannel channel = reader.channels().get(message.channelId());
      assertThat(channel.messageEncoding()).isEqualTo("cbor");
      assertThat(channel.metadata()).containsEntry("channel", "state");
      String schema = new String(reader.schemas().get(channel.schemaId()).data());
      assertThat(schema).contains("\"psiDot\":{\"type\":\"number\",\"unit\":\"rad/s\"}");
      assertThat(
              new MessageCodec(MessageTypes.discovered())
                  .decode(StateInformation.TYPE.chain(), message.data()))
          .isEqualTo(stamped(state(11.0)));
    }
  }

  private static StateInformation stamped(StateInformation state) {
    state.systemId("rover");
    state.timestamp(1_000);
    return state;
  }

  @Test
  void record_programExitsWithoutStoppingIt_fileIsWhole() throws Exception {
    Process program =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:TieredStopAtLevel=1",
                "-cp",
                System.getProperty("java.class.path"),
                ExitingProgram.class.getName(),
                folder.toString())
            .inheritIO()
            .start();
    assertThat(program.waitFor()).isEqualTo(7);
    assertThat(read(folder.resolve("recording.mcap")).get("u2sa/rover/state/StateInformation"))
        .hasSize(ExitingProgram.MESSAGES);
  }

  @Test
  void record_splitBySize_keepsTheNewestFilesEachComplete() throws IOException {
    Map<String, Object> values = new HashMap<>();
    values.put("SPLIT MEGABYTES", 0.01);
    values.put("KEEP", 3);
    values.put("FORM", "U2SA");
    values.put("COMPRESSION", "NONE");
    values.put("WAITING AT MOST", 100_000);
    RecorderVariables settings = FilesFixture.settings(values);
    RecordingFiles files =
        new RecordingFiles(
            folder.resolve("r.mcap"),
            settings,
            "test",
            new RecordingFacts().say("run", "seed", "5"),
            RecorderTest::fail);
    RecordedChannels channels = new RecordedChannels();
    StateInformation message = stamped(state(1.0));
    message.freeze();
    for (int i = 0; i < 2_000; i++) {
      long nanos = i * 10_000_000L; // a chunk each half a second
      channels.write(
          files.at(nanos, channels::nextFile),
          channels.of("rover", Channels.STATE, message),
          nanos,
          nanos,
          message.serialize());
    }
    files.end(0, Map.of());
    List<Path> left = list();
    assertThat(left).hasSize(3).isEqualTo(files.written());
    assertThat(left.get(0).getFileName()).hasToString(numberedFrom(left));
    int messages = 0;
    for (Path file : left) {
      try (McapReader reader = McapReader.open(file)) {
        assertThat(reader.metadata()).contains(new McapMetadata("run", Map.of("seed", "5")));
        messages += (int) reader.statistics().messages();
        assertThat(reader.channels()).as("defined in each file").hasSize(1);
        assertThat(reader.schemas()).hasSize(1);
      }
      assertThat(Files.size(file)).isBetween(2_000L, 25_000L);
    }
    assertThat(messages).isBetween(100, 1_000);
  }

  private static String numberedFrom(List<Path> left) {
    String last = left.get(2).getFileName().toString();
    int number = Integer.parseInt(last.replaceAll("\\D", ""));
    return String.format("r-%04d.mcap", number - 2);
  }

  private static void fail(String trouble) {
    throw new AssertionError(trouble);
  }

  private List<Path> list() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.filter(file -> file.toString().endsWith(".mcap")).sorted().toList();
    }
  }

  @Test
  void receive_moreThanMayWait_dropsAndCountsAndSaysSoInTheFile() throws IOException {
    List<String> told = new ArrayList<>();
    RecorderVariables settings =
        FilesFixture.settings(Map.of("WAITING AT MOST", 16, "FORM", "U2SA"));
    RecordingFiles files =
        new RecordingFiles(
            folder.resolve("r.mcap"), settings, "test", new RecordingFacts(), told::add);
    Recording recording = new Recording("rover", new SystemClock(), settings, files, told::add);
    StateInformation message = stamped(state(1.0));
    message.freeze();
    for (int i = 0; i < 20; i++) {
      recording.receive(Channels.STATE, message);
    }
    recording.start();
    recording.close();
    assertThat(recording.dropped()).isEqualTo(4);
    assertThat(told).hasSize(3).allMatch(line -> line.contains("dropped")); // at 1, 2 and 4
    try (McapReader reader = McapReader.open(folder.resolve("r.mcap"))) {
      assertThat(reader.statistics().messages()).isEqualTo(16);
      Map<String, String> counts = reader.metadata().get(0).entries();
      assertThat(counts).containsEntry("dropped", "4").containsEntry("messages", "20");
    }
  }

  @Test
  void receive_whileNoFileCanBeBegun_isCountedAndRecordingGoesOnOnceThereCan() throws IOException {
    Path file = folder.resolve("runs").resolve("r.mcap");
    Files.writeString(file.getParent(), "where the folder should be");
    List<String> told = new CopyOnWriteArrayList<>();
    Consumer<String> trouble =
        what -> {
          if (told.isEmpty()) {
            assertThat(file.getParent().toFile().delete()).isTrue();
          }
          told.add(what);
        };
    RecorderVariables settings = FilesFixture.settings(Map.of("FORM", "U2SA"));
    RecordingFiles files =
        new RecordingFiles(file, settings, "test", new RecordingFacts(), trouble);
    AtomicLong micros = new AtomicLong();
    Recording recording = new Recording("rover", clock(micros), settings, files, trouble);
    StateInformation message = stamped(state(1.0));
    message.freeze();
    recording.start();
    for (int i = 0; i < 3; i++) {
      recording.receive(Channels.STATE, message);
    }
    micros.set(10_000_000);
    recording.receive(Channels.STATE, message);
    recording.close();

    assertThat(told).hasSize(2).allMatch(line -> line.startsWith("recording into " + file + ": "));
    assertThat(told.get(1)).contains("recording again");
    try (McapReader reader = McapReader.open(file)) {
      assertThat(reader.statistics().messages()).isEqualTo(1);
      assertThat(reader.metadata().get(0).entries())
          .containsEntry("not-written", "3")
          .containsEntry("messages", "4");
    }
  }

  private static Clock clock(AtomicLong micros) {
    return new Clock() {
      @Override
      public long micros() {
        return micros.get();
      }

      @Override
      public Waiter newWaiter(String name) {
        throw new UnsupportedOperationException("nobody waits here");
      }
    };
  }

  @Test
  void record_filesOfTheRun_areAttached() throws IOException {
    Path system = Files.writeString(folder.resolve("system.xml"), "<system/>");
    Path gone = folder.resolve("gone.xml");
    Path log = folder.resolve("Planner.log");
    RecordingFacts facts =
        new RecordingFacts()
            .attach("config/system.xml", system)
            .attach("config/gone.xml", gone)
            .attachAtEnd(() -> Map.of("logs/Planner.log", log));
    Recorder recorder = new Recorder(context(Map.of()), facts);
    Files.writeString(log, "a line of the run's end");
    recorder.kill();
    try (McapReader reader = McapReader.open(folder.resolve("recording.mcap"))) {
      assertThat(reader.attachmentNames()).containsExactly("config/system.xml", "logs/Planner.log");
      assertThat(reader.attachment("logs/Planner.log").orElseThrow().data())
          .asString()
          .isEqualTo("a line of the run's end");
      assertThat(reader.metadata())
          .anySatisfy(
              metadata ->
                  assertThat(metadata.entries())
                      .containsEntry("seed", "5")
                      .containsEntry("system", "rover"))
          .anySatisfy(
              metadata -> {
                assertThat(metadata.name()).isEqualTo("not-attached");
                assertThat(metadata.entries()).containsOnlyKeys("config/gone.xml");
              });
    }
  }

  @Test
  void record_bytesOfPublishedMessage_areNotChangedByTheRecorder() throws IOException {
    Recorder recorder = new Recorder(context(Map.of("FORM", "FOXGLOVE")));
    publish(Channels.STATE, state(11.0));
    recorder.kill();
    Map<String, List<byte[]>> read = read(folder.resolve("recording.mcap"));
    assertThat(read).containsOnlyKeys("/rover/location", "/rover/pose", "/rover/transform");
    byte[] pose = read.get("/rover/pose").get(0);
    assertThat(Arrays.equals(pose, new byte[pose.length])).isFalse();
  }
}
