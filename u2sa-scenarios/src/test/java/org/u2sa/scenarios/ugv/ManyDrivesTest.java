package org.u2sa.scenarios.ugv;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.u2sa.scenarios.run.CommandLineRun;

/** Four loops of six waypoints over thirty seeds. */
@Tag("long")
class ManyDrivesTest {
  @TempDir private Path directory;

  static LongStream seeds() {
    return LongStream.rangeClosed(1, 30);
  }

  @ParameterizedTest(name = "seed {0}")
  @MethodSource("seeds")
  void demo_surveyReceiver_keepsAllBounds(long seed) {
    UgvDemoTest.requireGood(
        CommandLineRun.demo("ugv", directory, "--seed", String.valueOf(seed)), 24);
  }

  @ParameterizedTest(name = "seed {0}")
  @MethodSource("seeds")
  void demo_phoneReceiver_completesAllGoalsByItsOwnEstimate(long seed) {
    CommandLineRun run =
        CommandLineRun.demo(
            "ugv", directory, "--receiver", "phone", "--seed", String.valueOf(seed));

    assertThat(run.summary().get("goalsCompleted").asInt()).isEqualTo(24);
    assertThat(run.summary().get("violations").asInt()).isZero();
  }
}
