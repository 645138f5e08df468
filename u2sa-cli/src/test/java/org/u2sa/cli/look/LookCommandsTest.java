package org.u2sa.cli.look;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageIO;
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

/** The eyes of the command line on a system of another process: a rover that stands. */
@Timeout(180)
class LookCommandsTest extends CommandFixture {
  @TempDir private static Path directory;
  private static ForeignSystem foreign;

  @BeforeAll
  static void start() {
    foreign = ForeignSystem.start(directory, "rover", StandingRover.class.getName());
  }

  @AfterAll
  static void end() {
    foreign.close();
  }

  private int run(String... args) {
    List<String> all = new ArrayList<>(List.of(args));
    all.addAll(List.of("--broker", foreign.broker()));
    if (!all.contains("--timeout")) {
      all.addAll(List.of("--timeout", "60"));
    }
    return u2sa(all.toArray(String[]::new));
  }

  @Test
  void echo_once_showsFieldsWithUnits() {
    assertThat(run("echo", "state", "--once")).as(err.toString()).isEqualTo(ExitCode.DONE);
    assertThat(out.toString())
        .startsWith("state  StateInformation  ")
        .containsPattern("x +8.0 deg")
        .containsPattern("sensorName +rover");
  }

  @Test
  void echo_fieldsAsJson_areThoseFieldsOnly() throws Exception {
    assertThat(run("echo", "state", "--count", "2", "--field", "y,sensorName", "--json"))
        .isEqualTo(ExitCode.DONE);
    List<String> lines = out.toString().lines().toList();
    assertThat(lines).hasSize(2);
    JsonNode first = new ObjectMapper().readTree(lines.get(0));
    assertThat(first.get("fields").get("y").asDouble()).isEqualTo(50.0);
    assertThat(first.get("units").get("y").asText()).isEqualTo("deg");
    assertThat(first.get("fields").size()).isEqualTo(2);
  }

  @Test
  void echo_conditionThatNeverHolds_failsAfterTheTimeout() {
    int code = run("echo", "state", "--once", "--where", "x > 8", "--timeout", "3");
    assertThat(code).isEqualTo(ExitCode.FAILED);
    assertThat(err.toString()).contains("nothing received on \"state\"", "meets the conditions");
  }

  @Test
  void echo_misspeltChannel_suggests() {
    assertThat(run("echo", "stat", "--once", "--timeout", "3")).isEqualTo(ExitCode.FAILED);
    assertThat(err.toString()).contains("did you mean \"state\"?");
    assertThat(run("echo", "State", "--once")).isEqualTo(ExitCode.BAD_INPUT);
  }

  @Test
  void echo_variable_showsItsValueAndTheNextOne() throws Exception {
    Thread change =
        new Thread(
            () -> {
              StringWriter ignored = new StringWriter();
              Main.run(
                  new PrintWriter(ignored),
                  new PrintWriter(ignored),
                  "config",
                  "set",
                  "StandingRover",
                  "HEALTH INTERVAL=0.3",
                  "--broker",
                  foreign.broker(),
                  "--timeout",
                  "60");
            });
    assertThat(run("echo", "StandingRover:HEALTH INTERVAL", "--once")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("StandingRover:HEALTH INTERVAL = 0.25 s");
    change.start();
    change.join();
    assertThat(run("echo", "StandingRover:HEALTH INTERVAL", "--once", "--json"))
        .isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("\"value\":\"0.3\"");
    assertThat(run("echo", "StandingRover:HEALTH INTERVALL", "--once"))
        .isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("did you mean \"HEALTH INTERVAL\"?");
  }

  @Test
  void hz_ofAState_countsIt() throws Exception {
    assertThat(run("hz", "state", "--for", "3", "--json")).isEqualTo(ExitCode.DONE);
    JsonNode row = new ObjectMapper().readTree(out.toString()).get("channels").get(0);
    assertThat(row.get("source").asText()).isEqualTo("rover");
    assertThat(row.get("messages").asInt())
        .isBetween(2, 31); // 10 a second, on a busy machine fewer
    assertThat(row.get("rateHz").asDouble()).isPositive();
  }

  @Test
  void delayAndBw_ofAState_areTables() {
    assertThat(run("delay", "state", "--for", "2")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("MEDIAN").containsPattern("state +rover +StateInformation");
    assertThat(run("bw", "state", "--for", "2")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).containsPattern("\\d+ B/s|kB/s");
  }

  @Test
  void hz_channelWithoutMessages_fails() {
    assertThat(run("hz", "grid", "--for", "0.5")).isEqualTo(ExitCode.FAILED);
    assertThat(err.toString()).contains("nothing received", "grid");
  }

  @Test
  void publish_message_comesThroughAndIsHeard() throws Exception {
    assertThat(run("publish", "power", "{\"sensorName\": \"bench\", \"voltage\": \"11100 mV\"}"))
        .as(err.toString())
        .isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("published on power", "voltage=11.1 V");
  }

  @Test
  void publish_typeThatDoesNotTravelThere_isRefused() {
    assertThat(run("publish", "power", "{\"type\": \"Waypoint\", \"uid\": \"1\"}"))
        .isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("\"power\" does not carry a Waypoint", "BatteryState");
  }

  @Test
  void publish_abstractChannelWithoutType_namesTheTypes() {
    assertThat(run("publish", "mission", "{}")).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("MissionRequest", "MissionOrder");
  }

  @Test
  void plot_picture_isAPng() throws Exception {
    Path png = directory.resolve("plot.png");
    assertThat(run("plot", "state.x", "--for", "3", "--png", png.toString()))
        .as(err.toString())
        .isEqualTo(ExitCode.DONE);
    assertThat(ImageIO.read(Files.newInputStream(png)).getWidth()).isEqualTo(1000);
  }

  @Test
  void plot_inText_namesSeriesAndUnit() {
    assertThat(run("plot", "state.x", "--for", "3")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("state.x (rover) 8.0 deg", "┤");
  }

  @Test
  void log_ofTheRun_hasItsServices() {
    int code = u2sa("log", directory.resolve("logs").toString(), "--service", "StandingRover");
    assertThat(code).as(err.toString()).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("StandingRover: ");
  }
}
