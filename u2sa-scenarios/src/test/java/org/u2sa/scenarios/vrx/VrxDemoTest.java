package org.u2sa.scenarios.vrx;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.scenarios.run.CommandLineRun;

/** Whole tasks in worlds of our own, scored by truth. */
class VrxDemoTest {
  @TempDir private Path folder;

  private JsonNode run(String world, String... more) throws IOException {
    List<String> arguments = new ArrayList<>(List.of("demo", "vrx", "--port", "0", "--world"));
    arguments.add(VrxWorldReaderTest.WORLDS.resolve(world).toString());
    arguments.addAll(List.of("--out", folder.resolve("out").toString()));
    arguments.addAll(List.of(more));
    CommandLineRun run = CommandLineRun.of(arguments.toArray(new String[0]));
    assertThat(run.exitCode()).as(run.out() + run.err()).isEqualTo(ExitCode.DONE);
    return new ObjectMapper().readTree(Files.readString(folder.resolve("out/summary.json")));
  }

  @Test
  void call_stationInWindAndWaves_meanErrorIsBelowTheGoal() throws IOException {
    JsonNode summary = run("station.sdf", "--seed", "7");

    assertThat(summary.get("score").asDouble()).isBetween(0.001, 0.2);
  }

  @Test
  void call_waypointsInWindAndWaves_smallestErrorsAreBelowTheGoal() throws IOException {
    JsonNode summary = run("waypoints.sdf", "--seed", "7");

    assertThat(summary.get("score").asDouble()).isBetween(0.0, 0.05);
  }

  @Test
  void call_gatesWithObstacles_areFoundByTheirColours() throws IOException {
    JsonNode summary = run("gates.sdf", "--seed", "7", "--task", "path");

    assertThat(summary.get("score").asDouble()).isEqualTo(33.0);
    assertThat(summary.get("contacts").asInt()).isZero();
    assertThat(Files.readString(folder.resolve("out/mission.xml")))
        .as("no gate is told")
        .contains("gateCourse")
        .doesNotContain("waypoint");
  }

  @Test
  void call_animals_areCircledAndTheCrocodileAvoided() throws IOException {
    JsonNode summary = run("animals.sdf", "--seed", "7", "--task", "wildlife");

    assertThat(summary.get("animalsDealtWith").asDouble()).isEqualTo(3.0);
    assertThat(summary.get("score").asDouble()).isLessThan(-30.0);
    assertThat(summary.get("contacts").asInt()).isZero();
  }

  @Test
  void call_dockWithTwoSignsOfTheColour_docksAtTheOneOfTheSequence() throws IOException {
    JsonNode summary = run("dock.sdf", "--seed", "7", "--task", "dock");

    assertThat(summary.get("score").asDouble()).isEqualTo(30.0);
    assertThat(summary.get("contacts").asInt()).isZero();
  }

  @Test
  void call_taskOfAnotherWorld_isRefused() {
    CommandLineRun run =
        CommandLineRun.of(
            "demo",
            "vrx",
            "--task",
            "path",
            "--world",
            VrxWorldReaderTest.WORLDS.resolve("station.sdf").toString());

    assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(run.err()).contains("--task PATH").contains("STATIONKEEPING");
  }
}
