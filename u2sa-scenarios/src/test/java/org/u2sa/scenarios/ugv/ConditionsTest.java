package org.u2sa.scenarios.ugv;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.scenarios.run.CommandLineRun;

/** Motors, loads and ground that the configuration was not tuned on. */
class ConditionsTest {
  private static final double CROSS_TRACK_RMS_M = 0.15;

  @TempDir private Path directory;

  private CommandLineRun drive(String options) {
    return CommandLineRun.demo("ugv", directory, options.split(" "));
  }

  /** Fails unless one loop was driven, each waypoint within its threshold, and on its lines. */
  static void requireHeld(CommandLineRun run) {
    assertThat(run.exitCode()).as(run.out() + run.err()).isEqualTo(ExitCode.DONE);
    JsonNode summary = run.summary();
    assertThat(summary.get("goalsCompleted").asInt()).isEqualTo(6);
    assertThat(summary.get("waypointsCaptured").asInt()).isEqualTo(6);
    assertThat(summary.get("crossTrackRmsM").asDouble()).isLessThan(CROSS_TRACK_RMS_M);
  }

  @ParameterizedTest
  @ValueSource(strings = {"--mismatch 30 --payload 50 --surface field --seed 15"})
  void demo_unlikeMotorsLoadsAndGround_holdsTheLine(String options) {
    requireHeld(drive(options + " --loops 1"));
  }

  @Tag("long")
  @ParameterizedTest
  @ValueSource(
      strings = {
        "--mismatch 30 --payload 50 --seed 11",
        "--mismatch -50 --payload 20 --seed 12",
        "--mismatch 30 --payload 50 --control proportional --seed 13",
        "--mismatch -15 --payload 20 --hill 10 --seed 14"
      })
  void demo_unlikeMotorsLoadsHillOrControl_holdsTheLine(String options) {
    demo_unlikeMotorsLoadsAndGround_holdsTheLine(options);
  }

  @Test
  void demo_steeperThanTheMotorsCan_saysSoInTheLog() throws IOException {
    Path mission =
        Files.writeString(
            directory.resolve("uphill.xml"),
            "<mission><home><x>-81.0478</x><y>29.1885</y><psi>0</psi></home>"
                + "<waypoint><x>-81.0478</x><y>29.18854</y></waypoint></mission>");

    CommandLineRun run =
        CommandLineRun.demo(
            "ugv",
            directory.resolve("out"),
            "--mission",
            mission.toString(),
            "--payload",
            "120",
            "--slope",
            "10");

    assertThat(run.summary().get("goalsCompleted").asInt()).isZero();
    assertThat(Files.readString(directory.resolve("out/logs/Control.log")))
        .contains("the motors cannot move this load here: in 3.0 s at full power it went");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "--mismatch 60",
        "--payload -1",
        "--slope 30",
        "--hill 30",
        "--slope 5 --hill 5",
        "--vehicle ackermann --mismatch 5"
      })
  void demo_whatNoVehicleIs_isRefusedByName(String options) {
    CommandLineRun run = drive(options);

    assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(run.err())
        .contains(options.contains("mismatch") ? "--mismatch" : "--")
        .contains("expected");
  }
}
