package org.u2sa.cli.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.Main;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.ConfigurationAssignment;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.recorder.mcap.ChunkCompression;
import org.u2sa.recorder.mcap.McapOptions;
import org.u2sa.recorder.mcap.McapWriter;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapMessage;

/** A vehicle goes north at 1 m/s, one metre east of a line between two goals. */
class ReportTest {
  private static final double METRE_DEG = 1.0 / 111_000.0; // of latitude, near enough
  private static final double EAST_DEG = 1.0 / (111_000.0 * Math.cos(Math.toRadians(50.0)));

  @TempDir private Path folder;

  private final StringWriter out = new StringWriter();
  private boolean withGarbage;
  private final Map<String, McapChannel> channels = new HashMap<>();

  private void write(McapWriter writer, double timeS, Channel<?> channel, U2SAData message)
      throws IOException {
    message.timestamp(Math.round(timeS * 1e6));
    String topic = Topic.of("rover", channel, message).toString();
    McapChannel known = channels.get(topic);
    if (known == null) {
      known = new McapChannel(channels.size() + 1, 0, topic, "cbor", Map.of());
      channels.put(topic, known);
      writer.add(known);
    }
    long nanos = Math.round(timeS * 1e9) + 2_000_000; // recorded 2 ms later
    byte[] bytes = message.serialize();
    if (withGarbage && message instanceof ObjectList) {
      withGarbage = false;
      bytes[0] = 0; // no map any more
    }
    writer.add(new McapMessage(known.id(), 0, nanos, nanos, bytes));
  }

  private Path record(String name) throws IOException {
    Path file = Files.createDirectories(folder.resolve(name)).resolve("recording.mcap");
    StringBuilder truth =
        new StringBuilder("time_s,longitude_deg,latitude_deg,altitude_m,heading_deg\n");
    try (McapWriter writer =
        new McapWriter(
            Files.newByteChannel(
                file,
                java.nio.file.StandardOpenOption.CREATE,
                java.nio.file.StandardOpenOption.WRITE),
            McapOptions.usual(ChunkCompression.LZ4, "test"))) {
      Waypoint a = new Waypoint().uid("a").x(8.0).y(50.0 + 2 * METRE_DEG).horizontalThreshold(1.0);
      Waypoint b = new Waypoint().uid("b").x(8.0).y(50.0 + 99 * METRE_DEG).horizontalThreshold(1.0);
      for (int i = 0; i <= 100; i++) {
        StateInformation state =
            new StateInformation().sensorName("e").x(8.0 + (i < 10 ? 0 : EAST_DEG));
        state.y(50.0 + i * METRE_DEG).z(5.0).xDot(0.0).yDot(1.0).psi(0.1).xSigma(0.5).ySigma(0.4);
        write(writer, i, Channels.STATE, state);
        truth.append(i).append(",8.0,").append(50.0 + i * METRE_DEG).append(",4.0,0.0\n");
        if (i == 0) {
          write(writer, 0, Channels.GOALS, new GoalList().goals(List.of(a.copy(), b.copy())));
          write(writer, 0, Channels.CONDITIONS, condition(Condition.ALIVE));
          write(writer, 0, Channels.OBJECTS, new ObjectList().objects(obstacles()));
        }
        if (i == 2) {
          Waypoint reached = a.copy();
          reached.completed(true);
          write(writer, 2, Channels.GOAL_REPORTS, reached);
          write(writer, 2, Channels.GOALS, new GoalList().goals(List.of(b.copy())));
        }
        if (i == 50) {
          write(writer, 50, Channels.CONDITIONS, condition(Condition.SILENT));
          write(
              writer,
              50,
              Channels.FAILSAFE,
              new FailsafeState().action(FailsafeAction.HOLD).causes(List.of("</script><b>x")));
          write(writer, 50, Channels.CONFIGURATION, change());
        }
        write(
            writer,
            i,
            Channels.ACTUATION,
            new PercentageCommand().percentage(i).actuatorName("LEFT WHEEL"));
      }
    }
    Files.writeString(file.resolveSibling("track.csv"), truth);
    return file;
  }

  private static List<org.u2sa.messages.ObjectDescription> obstacles() {
    List<org.u2sa.messages.ObjectDescription> all = new ArrayList<>();
    all.add(new Cylinder().radius(0.5).height(1.0).uid("barrel").x(8.0).y(50.0 + 10 * METRE_DEG));
    all.add(
        new Box()
            .length(4.0)
            .width(2.0)
            .height(1.0)
            .psi(Math.PI / 2)
            .uid("box")
            .x(8.0)
            .y(50.0 + 20 * METRE_DEG));
    return all;
  }

  private static ServiceCondition condition(Condition condition) {
    ServiceCondition message = new ServiceCondition().condition(condition).reason("because");
    message.serviceName("Control");
    return message;
  }

  private static ConfigurationTransactionResult change() {
    ConfigurationTransactionResult result = new ConfigurationTransactionResult();
    result.accepted(true).reason("").revision(1).author("ann");
    result.assignments(
        List.of(new ConfigurationAssignment().variableName("GAIN").value("2").previous("1")));
    result.requestId("1").serviceName("Control");
    return result;
  }

  private int run(String... arguments) {
    PrintWriter writer = new PrintWriter(out);
    return Main.run(writer, writer, arguments);
  }

  private JsonNode json(String... arguments) throws IOException {
    assertThat(run(arguments)).as(out.toString()).isEqualTo(ExitCode.DONE);
    return new ObjectMapper().readTree(out.toString());
  }

  private static JsonNode named(JsonNode list, String key, String name) {
    for (JsonNode each : list) {
      if (each.get(key).asText().equals(name)) {
        return each;
      }
    }
    throw new AssertionError("no " + name + " in " + list);
  }

  private static double figure(JsonNode run, String name) {
    return named(run.get("figures"), "name", name).get("value").asDouble();
  }

  @Test
  void report_messageThatCannotBeDecoded_isLeftOutAndSaid() throws IOException {
    withGarbage = true;

    JsonNode run = json("report", record("drive").toString(), "--json").get("runs").get(0);

    assertThat(figure(run, "duration")).isEqualTo(100.0);
    assertThat(named(run.get("facts"), "name", "not decoded").get("value").asText())
        .startsWith(
            "messages that cannot be decoded: 1, the first on u2sa/rover/objects/ObjectList: ");
  }

  @Test
  void report_json_hasWhatHappened() throws IOException {
    JsonNode run = json("report", record("drive").toString(), "--json").get("runs").get(0);
    assertThat(run.get("name").asText()).isEqualTo("drive");
    assertThat(figure(run, "duration")).isEqualTo(100.0);
    assertThat(figure(run, "goals begun")).isEqualTo(2.0);
    assertThat(figure(run, "goals reached")).isEqualTo(1.0);
    assertThat(figure(run, "failsafes")).isEqualTo(1.0);
    assertThat(figure(run, "services not alive")).isEqualTo(1.0);
    assertThat(figure(run, "configuration changes")).isEqualTo(1.0);
    assertThat(run.get("timeline").get("events").findValuesAsText("text"))
        .contains(
            "goal a reached",
            "HOLD: </script><b>x",
            "Control GAIN: 1 → 2, by ann",
            "Control is SILENT: because");
    JsonNode condition = run.get("timeline").get("conditions").get(0);
    assertThat(condition.get("changes").findValuesAsText("condition"))
        .containsExactly("ALIVE", "SILENT");
  }

  @Test
  void report_truthBeside_errorsAreEstimateMinusTruth() throws IOException {
    JsonNode run = json("report", record("drive").toString(), "--json").get("runs").get(0);
    JsonNode position = named(run.get("charts"), "title", "Position error, and 2σ as estimated");
    JsonNode east = named(position.get("lines"), "name", "east").get("v");
    assertThat(east.get(5).asDouble()).isCloseTo(0.0, within(0.01));
    assertThat(east.get(80).asDouble()).isCloseTo(1.0, within(0.02));
    assertThat(position.get("sigma").get("v").get(0).asDouble()).isEqualTo(0.5);
    JsonNode heading = named(run.get("charts"), "title", "Heading error, and 2σ as estimated");
    assertThat(heading.get("lines").get(0).get("v").get(0).asDouble())
        .isCloseTo(Math.toDegrees(0.1), within(1e-3));
    JsonNode off = named(run.get("charts"), "title", "Cross-track error between goals (right +)");
    JsonNode estimated = named(off.get("lines"), "name", "estimated").get("v");
    assertThat(estimated.get(estimated.size() - 1).asDouble()).isCloseTo(1.0, within(0.02));
    assertThat(figure(run, "cross-track error, maximum"))
        .isCloseTo(0.0, within(0.02)); // the truth's
    JsonNode latency = named(run.get("latency"), "channel", "state");
    assertThat(latency.get("p50Ms").asDouble()).isEqualTo(2.0);
  }

  @Test
  void report_map_hasTrackGoalsAndObstaclesInMetres() throws IOException {
    JsonNode map =
        json("report", record("drive").toString(), "--json").get("runs").get(0).get("map");
    assertThat(map.get("track").get(3 * 100 + 2).asDouble()).isCloseTo(100.0, within(0.5));
    JsonNode a = named(map.get("goals"), "name", "a");
    assertThat(a.get("done").asBoolean()).isTrue();
    assertThat(a.get("y").asDouble()).isCloseTo(2.0, within(0.05));
    assertThat(named(map.get("goals"), "name", "b").get("done").asBoolean()).isFalse();
    assertThat(named(map.get("objects"), "name", "barrel").get("r").asDouble()).isEqualTo(0.5);
    JsonNode box = named(map.get("objects"), "name", "box").get("outline"); // 4 m to the east
    double least = Double.POSITIVE_INFINITY;
    double greatest = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < box.size(); i += 2) {
      least = Math.min(least, box.get(i).asDouble());
      greatest = Math.max(greatest, box.get(i).asDouble());
    }
    assertThat(greatest - least).isCloseTo(4.0, within(1e-3));
  }

  @Test
  void report_page_isOneFileWithoutAddresses() throws IOException {
    Path file = record("drive");
    assertThat(run("report", file.toString())).as(out.toString()).isEqualTo(ExitCode.DONE);
    String page = Files.readString(file.resolveSibling("recording.html"), StandardCharsets.UTF_8);
    assertThat(page)
        .doesNotContain("{{", "https://", "src=", "</script><b>")
        .contains("\\u003c/script>\\u003cb>x");
    assertThat(page.replace("http://www.w3.org/2000/svg", "")).doesNotContain("http://");
  }

  @Test
  void compare_twoRuns_hasBoth() throws IOException {
    Path a = record("a");
    channels.clear();
    Path b = record("b");
    Files.delete(b.resolveSibling("track.csv"));
    JsonNode runs = json("compare", a.toString(), b.toString(), "--json").get("runs");
    assertThat(runs.findValuesAsText("name")).contains("a", "b");
    assertThat(runs.get(0).get("map").has("truth")).isTrue();
    assertThat(runs.get(1).get("map").has("truth")).isFalse();
    assertThat(figure(runs.get(1), "cross-track error, maximum")).isCloseTo(1.0, within(0.02));
  }

  @Test
  void compare_outputForgotten_keepsTheRecordingInItsPlace() throws IOException {
    Path a = record("a");
    byte[] before = Files.readAllBytes(a);
    channels.clear();
    Path b = record("b");

    assertThat(run("compare", "-o", a.toString(), b.toString(), b.toString()))
        .isEqualTo(ExitCode.BAD_INPUT);
    assertThat(run("report", a.toString(), "-o", a.toString())).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(run("export", a.toString(), "--format", "kml", "--out", a.toString()))
        .isEqualTo(ExitCode.BAD_INPUT);

    assertThat(out.toString()).contains(a + " is a recording");
    assertThat(a).hasBinaryContent(before);
  }

  @Test
  void replay_partOfARerun_isRefused() throws IOException {
    String file = record("a").toString();

    assertThat(run("replay", file, "--rerun", "Control", "--from", "1"))
        .isEqualTo(ExitCode.BAD_INPUT);

    assertThat(out.toString()).contains("--from: cannot be used with --rerun");
  }

  @Test
  void report_wrongFiles_areRefused() throws IOException {
    assertThat(run("report", folder.resolve("none.mcap").toString())).isEqualTo(ExitCode.BAD_INPUT);
    Path file = record("drive");
    Path csv = Files.writeString(folder.resolve("other.csv"), "a,b\n1,2\n");
    assertThat(run("report", file.toString(), "--truth", csv.toString()))
        .isEqualTo(ExitCode.BAD_INPUT);
    assertThat(out.toString()).contains("other.csv: expected a demo's track.csv", "time_s");
  }
}
