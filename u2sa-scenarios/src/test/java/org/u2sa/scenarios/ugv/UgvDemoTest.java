package org.u2sa.scenarios.ugv;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.scenarios.run.CommandLineRun;

/** Whole drives by the command line: board, drivers and services in lockstep, judged by truth. */
class UgvDemoTest {
  private static final double LARGEST_MISS_M = 2.0;
  private static final double LARGEST_CROSS_TRACK_RMS_M = 0.5;

  @TempDir private Path directory;

  private CommandLineRun drive(String name, String... options) {
    return CommandLineRun.demo("ugv", directory.resolve(name), options);
  }

  /** Fails unless the drive kept every bound of the project's fourth issue. */
  static void requireGood(CommandLineRun run, int goals) {
    assertThat(run.exitCode()).as(run.err()).isEqualTo(ExitCode.DONE);
    JsonNode summary = run.summary();
    assertThat(summary.get("goals").asInt()).isEqualTo(goals);
    assertThat(summary.get("goalsCompleted").asInt()).isEqualTo(goals);
    assertThat(summary.get("waypointsCaptured").asInt()).isEqualTo(goals);
    for (JsonNode waypoint : summary.get("perWaypoint")) {
      assertThat(waypoint.get("missM").asDouble())
          .as(waypoint.toString())
          .isLessThanOrEqualTo(LARGEST_MISS_M);
    }
    assertThat(summary.get("crossTrackRmsM").asDouble())
        .isLessThanOrEqualTo(LARGEST_CROSS_TRACK_RMS_M);
    assertThat(summary.get("contacts").asInt()).isZero();
    assertThat(summary.get("violations").asInt()).isZero();
  }

  @ParameterizedTest(name = "seed {0}")
  @ValueSource(longs = 1)
  void demo_twoLoops_keepsAllBounds(long seed) {
    requireGood(drive("out", "--seed", String.valueOf(seed), "--loops", "2"), 12);
  }

  @Tag("long")
  @ParameterizedTest(name = "seed {0}")
  @ValueSource(longs = {2, 3})
  void demo_twoLoopsMoreSeeds_keepsAllBounds(long seed) {
    demo_twoLoops_keepsAllBounds(seed);
  }

  @ParameterizedTest(name = "{0}, {1}")
  @CsvSource({"differential, proportional", "ackermann, pursuit"})
  void demo_otherVehicleOrControl_keepsAllBounds(String vehicle, String control) {
    requireGood(
        drive("out", "--vehicle", vehicle, "--control", control, "--loops", "1", "--seed", "4"), 6);
  }

  @Test
  void demo_phoneReceiver_completesAllGoalsByItsOwnEstimate() {
    CommandLineRun run = drive("out", "--receiver", "phone", "--loops", "1", "--seed", "2");

    assertThat(run.summary().get("goalsCompleted").asInt()).as(run.out()).isEqualTo(6);
  }

  @Test
  void demo_sameSeed_sameBytesOfTrack() {
    String mission = OneWaypoint.in(directory).toString();
    CommandLineRun once = drive("once", "--seed", "5", "--mission", mission);
    CommandLineRun again = drive("again", "--seed", "5", "--mission", mission);
    CommandLineRun other = drive("other", "--seed", "6", "--mission", mission);

    assertThat(again.track()).isEqualTo(once.track());
    assertThat(other.track()).isNotEqualTo(once.track());
  }

  @Test
  void demo_controlsSwappedWhileDriving_keepsAllBounds() {
    String pursuit = ":Control=org.u2sa.control.ground.DifferentialPursuitControl";
    String proportional = ":Control=org.u2sa.control.ground.DifferentialDriveControl";

    CommandLineRun run =
        drive(
            "out",
            "--seed",
            "7",
            "--loops",
            "1",
            "--swap",
            "12" + proportional,
            "--swap",
            "40" + pursuit,
            "--swap",
            "70" + proportional,
            "--swap",
            "100" + pursuit);

    assertThat(run.out()).contains("12.0 s: Control swapped", "100.0 s: Control swapped");
    requireGood(run, 6);
  }

  @Test
  void demo_swapRefusedWhileDriving_isAViolationAmongTheResults() {
    String mission = OneWaypoint.in(directory).toString();
    CommandLineRun run =
        drive(
            "out",
            "--seed",
            "7",
            "--mission",
            mission,
            "--swap",
            "5:Control=org.u2sa.control.fixedwing.CessnaControl");

    assertThat(run.exitCode()).isEqualTo(ExitCode.FAILED);
    assertThat(run.track()).isNotEmpty();
    JsonNode summary = run.summary();
    assertThat(summary.get("goalsCompleted").asInt()).isEqualTo(1);
    assertThat(summary.get("violationDetails").get(0).asText())
        .contains("5.0 s: Control not swapped");
  }

  @Test
  void demo_proportionalControlOfAckermannVehicle_isRefused() {
    CommandLineRun run = drive("out", "--vehicle", "ackermann", "--control", "proportional");

    assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(run.err()).contains("expected pursuit with --vehicle ackermann");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          --set  | Nope:X=1 | lists no service of class "Nope"
          --set  | Contrl:RATE=50 | expected one of
          --set  | UgvPlanner:RATE=50 | lists no service of class
          --set  | IoioService:NOPE=1 | variable "NOPE": no service declares it
          --swap | 5:x=org.u2sa.planning.PathPlanner | no service "x" is running; expected one of
          --swap | 5:Contrl=org.u2sa.planning.PathPlanner | did you mean "Control"?
          """)
  void demo_whatWouldHaveNoEffect_isRefused(String option, String value, String expected) {
    CommandLineRun run = drive("out", "--loops", "1", option, value);

    assertThat(run.err()).contains(expected);
    assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
  }

  @Test
  void demo_noLoops_isRefused() {
    CommandLineRun run = drive("out", "--loops", "0");

    assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(run.err()).contains("--loops 0: expected 1 or more");
  }
}
