package org.u2sa.scenarios.ugv;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.scenarios.run.CommandLineRun;
import org.u2sa.testkit.Repository;

/**
 * Obstacles on every leg of the loop, known to nobody: the laser sees them, the World Modeler's
 * grid keeps them, the planner leads around them. Judged by truth.
 */
class ObstructedLoopTest {
  @TempDir private Path directory;

  private CommandLineRun drive(long seed, String... more) {
    String world = Repository.root().resolve("missions/ugv/obstructed.xml").toString();
    String[] options = {"--loops", "1", "--seed", String.valueOf(seed), "--world", world};
    String[] all = Arrays.copyOf(options, options.length + more.length);
    System.arraycopy(more, 0, all, options.length, more.length);
    return CommandLineRun.demo("ugv", directory.resolve("out" + seed), all);
  }

  private static void requireUntouched(CommandLineRun run) {
    assertThat(run.exitCode()).as(run.out() + run.err()).isEqualTo(ExitCode.DONE);
    assertThat(run.summary().get("waypointsCaptured").asInt()).isEqualTo(6);
    assertThat(run.summary().get("contacts").asInt()).isZero();
    assertThat(run.summary().get("crossTrackRmsM").asDouble())
        .as("the lines are blocked: whoever stays on them has seen nothing")
        .isGreaterThan(1.0);
  }

  @Test
  void demo_obstaclesOnEveryLeg_areDrivenAround() {
    requireUntouched(drive(1));
  }

  @Tag("long")
  @ParameterizedTest
  @ValueSource(longs = {2, 3, 4, 5, 6, 7, 8, 9, 10, 11})
  void demo_manySeeds_areDrivenAround(long seed) {
    requireUntouched(drive(seed));
  }

  @Test
  void demo_worldWithTheProportionalControl_isRefused() {
    CommandLineRun run = drive(1, "--control", "proportional");
    assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(run.err()).contains("--world: expected --control pursuit");
  }
}
