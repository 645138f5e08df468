package org.u2sa.cli.describe;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.CommandFixture;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.remote.ForeignSystem;

/** {@code u2sa describe} by files, and of a system of another process. */
@Timeout(120)
class DescribeCommandTest extends CommandFixture {
  @TempDir private static Path directory;
  private static ForeignSystem foreign;

  @BeforeAll
  static void start() {
    foreign =
        ForeignSystem.start(
            directory,
            "rover",
            Flashlight.class.getName(),
            "org.u2sa.estimation.PassThroughStateEstimator");
  }

  @AfterAll
  static void end() {
    foreign.close();
  }

  /** A vehicle of core services with a mission. */
  private static String rover() throws IOException {
    Files.writeString(
        directory.resolve("mission.xml"), "<mission><waypoint><x>1</x></waypoint></mission>");
    Files.writeString(
        directory.resolve("MissionManager.xml"),
        "<configuration><variable name=\"MISSION\" type=\"string\" value=\"mission.xml\"/>"
            + "<variable name=\"DEFAULT THRESHOLD\" type=\"double\" value=\"0.5\" unit=\"m\"/></configuration>");
    Path file = directory.resolve("rover.xml");
    Files.writeString(
        file,
        "<system id=\"rover\">"
            + "<autonomy perception=\"discrete\" decision=\"2\" independence=\"Problem detection\"/>"
            + service(Flashlight.class.getName(), "")
            + service("org.u2sa.estimation.PassThroughStateEstimator", "")
            + service("org.u2sa.mission.MissionManager", " configuration=\"MissionManager.xml\"")
            + service("org.u2sa.planning.PathPlanner", "")
            + service("org.u2sa.control.ground.DifferentialPursuitControl", "")
            + service("org.u2sa.core.safety.SafetyManager", "")
            + service("org.u2sa.core.health.HealthMonitor", "")
            + "</system>");
    return file.toString();
  }

  private static String service(String className, String more) {
    return "<service class=\"" + className + "\"" + more + "/>";
  }

  @Test
  void describe_systemFile_tellsLevelsServicesAndChannels() throws IOException {
    String file = rover();
    assertThat(u2sa("describe", file)).as(err.toString()).isEqualTo(ExitCode.DONE);
    assertThat(out.toString())
        .contains("System rover by " + file)
        .containsPattern("perception +2 discrete +2 discrete +Flashlight measures the vehicle")
        .containsPattern("decision +2 static response +2 static response +MissionManager chooses")
        .containsPattern("independence +5 problem detection +5 problem detection +SafetyManager")
        .contains(
            "Flashlight measures the vehicle.\nStateEstimator makes one estimate of its position and motion")
        .contains("MissionManager chooses the next goal.\nPathPlanner plans the route there")
        .contains("PathPlanner, path planner, org.u2sa.planning.PathPlanner")
        .containsPattern("configuration +.*MissionManager.xml")
        .containsPattern("hears .*goals from MissionManager")
        .containsPattern("publishes .*navigation to ")
        .doesNotContain("DEFAULT THRESHOLD");
    assertThat(err.toString()).isEmpty();
  }

  @Test
  void describe_variables_tellsWhatFilesSet() throws IOException {
    assertThat(u2sa("describe", rover(), "--variables")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("DEFAULT THRESHOLD = 0.5 m");
  }

  @Test
  void describe_moreIsStatedThanShown_saysSo() throws IOException {
    Path file =
        Files.writeString(
            directory.resolve("bold.xml"),
            "<system id=\"bold\"><autonomy perception=\"classification\" decision=\"1\" independence=\"1\"/>"
                + "<service class=\"org.u2sa.estimation.PassThroughStateEstimator\"/></system>");
    assertThat(u2sa("describe", file.toString())).isEqualTo(ExitCode.DONE);
    assertThat(out.toString())
        .containsPattern("perception +4 classification +1 no sensing")
        .contains("More perception is stated than services and channels show: 4 classification")
        .doesNotContain("More decision");
  }

  @Test
  void describe_running_tellsSourcesWithSigmasAndActuatorsWithNumbers() {
    assertThat(u2sa("describe", "--connect", "--broker", foreign.broker(), "--timeout", "60"))
        .isEqualTo(ExitCode.DONE);
    assertThat(out.toString())
        .contains("System rover running at " + foreign.broker())
        .containsPattern("perception +- +2 discrete +Flashlight measures the vehicle")
        .containsPattern(
            "sensed-state +flashlight +StateInformation +\\d+\\.\\d Hz +x y +x 1\\.5 m, y 2 m")
        .contains("state: to no service")
        .containsPattern(
            "LAMP: minimum 0 %, maximum 100 %, effect lights, .*rateLimit 50 %/s, force .*-0\\.25.* N");
  }

  @Test
  void describe_json_isReadByPrograms() throws IOException {
    assertThat(
            u2sa(
                "describe", "--connect", "--broker", foreign.broker(), "--timeout", "60", "--json"))
        .isEqualTo(ExitCode.DONE);
    JsonNode root = new ObjectMapper().readTree(out.toString());

    assertThat(root.get("live").asBoolean()).isTrue();
    assertThat(root.get("autonomy").get("perception").get("shown").get("level").asInt())
        .isEqualTo(2);
    assertThat(root.get("sources").findValuesAsText("sensor")).contains("flashlight");
    assertThat(root.get("actuators").get(0).get("announces").get("maximum").asText())
        .isEqualTo("100 %");
  }

  @Test
  void describe_nothing_isBadInput() {
    assertThat(u2sa("describe")).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("expected a system file, --connect, or both");
  }

  @Test
  void describe_wrongFile_isBadInput() {
    assertThat(u2sa("describe", directory.resolve("none.xml").toString()))
        .isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("none.xml");
  }

  @Test
  void describe_serviceThatCannotBeMade_saysWhyAndGoesOn() throws IOException {
    Path file =
        Files.writeString(
            directory.resolve("half.xml"),
            "<system id=\"half\"><service class=\"org.u2sa.mission.MissionManager\"/>"
                + "<service class=\"org.u2sa.estimation.PassThroughStateEstimator\"/></system>");
    assertThat(u2sa("describe", file.toString())).isEqualTo(ExitCode.DONE);
    assertThat(out.toString())
        .contains("could not be created here: ", "StateEstimator, state estimator");
  }
}
