package org.u2sa.scenarios.simulate;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.scenarios.run.CommandLineRun;
import org.u2sa.testkit.Repository;

/** Which goals count as completed, with a hexacopter that passes near all of its goals. */
class GoalsCompletedTest {
  @TempDir private Path folder;

  private final List<String> arguments = new ArrayList<>();

  @BeforeEach
  void prepare() throws IOException {
    Path config = Repository.root().resolve("config/suas/hexacopter");
    Path mission =
        Files.writeString(
            folder.resolve("mission.xml"),
            """
            <mission>
              <home><x>-76.55578</x><y>38.31633</y><z>43.3</z><psi>100</psi></home>
              <takeOff><name>up</name><z>63</z></takeOff>
              <waypoint><name>there</name><x>-76.55543652</x><y>38.31633</y><z>63</z></waypoint>
              <landing><name>down</name><x>-76.55578</x><y>38.31633</y><z>43.3</z></landing>
            </mission>
            """);
    arguments.addAll(List.of("simulate", config.resolve("system.xml").toString()));
    arguments.addAll(List.of("--vehicle", config.resolve("vehicle.xml").toString()));
    arguments.addAll(List.of("--mission", mission.toString(), "--port", "0"));
    arguments.addAll(List.of("--out", folder.resolve("out").toString()));
  }

  private void requireNotLanded(String... more) throws IOException {
    arguments.addAll(List.of(more));
    CommandLineRun run = CommandLineRun.of(arguments.toArray(new String[0]));

    JsonNode summary =
        new ObjectMapper().readTree(Files.readString(folder.resolve("out/summary.json")));
    assertThat(run.exitCode()).as(run.out() + run.err()).isEqualTo(ExitCode.FAILED);
    assertThat(run.out()).contains("goal \"down\" was not completed");
    assertThat(summary.get("success").asBoolean()).isFalse();
    assertThat(summary.get("goals").asInt()).isEqualTo(3);
    assertThat(summary.get("goalsCompleted").asInt()).isEqualTo(2);
    assertThat(summary.get("waypointsCaptured").asInt())
        .as("it was above the place of the landing")
        .isEqualTo(2);
  }

  @Test
  void simulate_returnByFailsafe_isNoGoalOfTheMission() throws IOException {
    Path fence =
        Files.writeString(
            folder.resolve("fence.xml"),
            """
            <fence>
              <keepIn>
                <corner><x>-76.5567</x><y>38.3156</y></corner>
                <corner><x>-76.5544</x><y>38.3156</y></corner>
                <corner><x>-76.5544</x><y>38.3174</y></corner>
                <corner><x>-76.5567</x><y>38.3174</y></corner>
              </keepIn>
              <floor>50</floor>
            </fence>
            """);

    requireNotLanded(
        "--set",
        "SafetyManager:FENCE=" + fence,
        "--set",
        "SafetyManager:ON FENCE=RETURN",
        "--limit",
        "60");

    assertThat(Files.readString(folder.resolve("out/logs/MissionManager.log")))
        .contains("RETURN home");
  }

  @Test
  void simulate_endedDuringTheDescent_hasNotCompletedTheLanding() throws IOException {
    requireNotLanded("--limit", "30");
  }
}
