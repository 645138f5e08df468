package org.u2sa.cli.services;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.CommandFixture;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.remote.ForeignSystem;

/** What operators see of a system of another process, and what becomes of their orders. */
@Timeout(120)
class ServiceCommandsTest extends CommandFixture {
  private static final String ESTIMATOR = "org.u2sa.estimation.PassThroughStateEstimator";

  @TempDir private static Path directory;
  private static ForeignSystem foreign;

  @BeforeAll
  static void start() throws Exception {
    Path own = Files.createDirectory(directory.resolve("rover"));
    foreign = ForeignSystem.start(own, "rover", ESTIMATOR, Lidar.class.getName());
  }

  @AfterAll
  static void end() {
    foreign.close();
  }

  private int run(ForeignSystem system, String... args) {
    List<String> all = new ArrayList<>(List.of(args));
    all.addAll(List.of("--broker", system.broker()));
    if (!all.contains("--timeout")) {
      all.addAll(List.of("--timeout", "60")); // ends with the answers
    }
    return u2sa(all.toArray(String[]::new));
  }

  private int run(String... args) {
    return run(foreign, args);
  }

  @Test
  void services_listsEachWithTypeAndHealth() {
    assertThat(run("services")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString())
        .contains("System rover", "NAME", "UPTIME", "INBOX")
        .containsPattern("Lidar +proprioceptive sensor +running ")
        .containsPattern("StateEstimator +state estimator +running ");
    assertThat(err.toString()).isEmpty();
  }

  @Test
  void services_json_isReadByPrograms() throws Exception {
    assertThat(run("services", "--json")).isEqualTo(ExitCode.DONE);
    JsonNode root = new ObjectMapper().readTree(out.toString());
    assertThat(root.get("system").asText()).isEqualTo("rover");
    assertThat(root.get("services").findValuesAsText("name")).contains("Lidar", "StateEstimator");
    JsonNode lidar =
        root.get("services").get(root.get("services").findValuesAsText("name").indexOf("Lidar"));
    assertThat(lidar.get("publishes").get(0).get("channel").asText()).isEqualTo("sensed-state");
    assertThat(lidar.get("health").get("dropped").isNumber()).isTrue();
  }

  @Test
  void services_publishing_findsByData() {
    assertThat(run("services", "--publishing", "StateInformation")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString())
        .containsPattern("Lidar +sensed-state")
        .containsPattern("StateEstimator +state ");
  }

  @Test
  void services_subscribing_findsByData() {
    assertThat(run("services", "--subscribing", "GoalList")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("Lidar").doesNotContain("StateEstimator");
  }

  @Test
  void services_publishingWhatNobodyHas_saysSoAndFails() {
    assertThat(run("services", "--publishing", "ObjectList")).isEqualTo(ExitCode.FAILED);
    assertThat(out.toString()).contains("No service publishes ObjectList.");
  }

  @Test
  void services_publishingMisspeltType_suggests() {
    assertThat(run("services", "--publishing", "StateInformaton")).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString())
        .contains("\"StateInformaton\"", "did you mean \"StateInformation\"?");
  }

  @Test
  void services_tableAndDataAtOnce_isBadInput() {
    assertThat(run("services", "--json", "--publishing", "StateInformation"))
        .isEqualTo(ExitCode.BAD_INPUT);
  }

  @Test
  void graph_text_namesFeedsAndLooseEnds() {
    assertThat(run("graph")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString())
        .containsPattern("Lidar +-> StateEstimator +sensed-state +StateInformation")
        .containsPattern("(?s)Published without subscribers:.*Lidar +power +BatteryState")
        .containsPattern("(?s)Subscribed to without publishers:.*Lidar +goals +GoalList");
  }

  @Test
  void graph_mermaidAndDot_nameTheSameFeeds() {
    assertThat(run("graph", "--format", "mermaid")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString())
        .startsWith("flowchart LR")
        .contains("[\"Lidar<br/>", "|\"sensed-state<br/>StateInformation\"|");

    assertThat(run("graph", "--format", "dot")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("\"Lidar\" -> \"StateEstimator\"");
  }

  @Test
  void graph_unknownFormat_isBadInput() {
    assertThat(run("graph", "--format", "svg")).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("--format", "svg", "MERMAID");
  }

  @Test
  void stop_unknownName_suggestsAndStopsNobody() {
    assertThat(run("stop", "Lider")).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("no service \"Lider\"", "did you mean \"Lidar\"?");
    assertThat(run("services")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("Lidar");
  }

  @Test
  void restart_service_runsAnew() {
    assertThat(run("restart", "Lidar", "--timeout", "20")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("Lidar: restarted");
  }

  @Test
  void restart_unknownName_saysThatNobodyAnswered() {
    assertThat(run("restart", "Lider", "--timeout", "0.5")).isEqualTo(ExitCode.FAILED);
    assertThat(err.toString()).contains("no launcher answered", "did you mean \"Lidar\"?");
  }

  @Test
  void swap_classThatIsNone_tellsTheLaunchersReason() {
    assertThat(run("swap", "Lidar", "org.example.Nothing", "--timeout", "20"))
        .isEqualTo(ExitCode.FAILED);
    assertThat(err.toString()).contains("SWAP Lidar was not carried out: ", "org.example.Nothing");
  }

  @Test
  void stop_one_thenAll_namesWhoStoppedAndTheProcessEnds() throws Exception {
    Path own = Files.createDirectory(directory.resolve("boat"));
    try (ForeignSystem boat = ForeignSystem.start(own, "boat", ESTIMATOR, Lidar.class.getName())) {
      assertThat(run(boat, "stop", "Lidar", "--timeout", "20")).isEqualTo(ExitCode.DONE);
      assertThat(out.toString()).contains("Lidar: stopped").doesNotContain("StateEstimator");

      assertThat(run(boat, "stop", "--timeout", "20"))
          .as(out + "\n" + err)
          .isEqualTo(ExitCode.DONE);
      assertThat(out.toString()).contains("StateEstimator: stopped");
      assertThat(boat.awaitEnd()).isTrue();
    }
  }

  @Test
  void stop_oneThatHangs_isNamedAndFails() throws Exception {
    Path own = Files.createDirectory(directory.resolve("mule"));
    try (ForeignSystem mule =
        ForeignSystem.start(own, "mule", ESTIMATOR, Stubborn.class.getName())) {
      assertThat(run(mule, "stop", "--timeout", "6")).isEqualTo(ExitCode.FAILED);
      assertThat(out.toString()).contains("StateEstimator: stopped", "Stubborn: DID NOT CONFIRM");
    }
  }
}
