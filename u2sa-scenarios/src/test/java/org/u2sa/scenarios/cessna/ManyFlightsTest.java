package org.u2sa.scenarios.cessna;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.scenarios.run.CommandLineRun;

/** Flights over many seeds: the demo's mission in many winds, and missions nobody tuned for. */
@Tag("long")
class ManyFlightsTest {
  @TempDir private Path directory;

  @ParameterizedTest(name = "seed {0}")
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20})
  void demo_windOfTheSeed_keepsAllBounds(long seed) {
    fly(seed, "--seed", String.valueOf(seed));
  }

  @ParameterizedTest(name = "seed {0}")
  @ValueSource(
      longs = {
        101, 102, 103, 104, 105, 106, 107, 108, 109, 110, 111, 112, 113, 114, 115, 116, 117, 118,
        119, 120
      })
  void demo_randomMission_keepsAllBounds(long seed) throws IOException {
    Path mission = directory.resolve("mission.xml");
    Files.writeString(mission, RandomMission.ofSeed(seed));

    fly(seed, "--seed", String.valueOf(seed), "--mission", mission.toString());
  }

  /**
   * Strong wind from eight directions; altitude and bank may leave the bounds of the demo's own.
   */
  @ParameterizedTest(name = "12 m/s from {0} deg")
  @ValueSource(ints = {0, 45, 90, 135, 180, 225, 270, 315})
  void demo_strongWind_capturesAllWithoutAStall(int fromDeg) {
    for (long seed : new long[] {11, 13}) {
      Path out = directory.resolve("out" + seed);
      CommandLineRun run =
          CommandLineRun.demo(
              "cessna", out, "--seed", String.valueOf(seed), "--wind", "12@" + fromDeg);

      assertThat(run.exitCode()).as("seed %d: %s%s", seed, run.err(), Summary.in(out)).isZero();
    }
  }

  private void fly(long seed, String... options) {
    Path out = directory.resolve("out");
    CommandLineRun run = CommandLineRun.demo("cessna", out, options);

    assertThat(run.exitCode()).as("seed %d: %s%s", seed, run.err(), Summary.in(out)).isZero();
    Summary.in(out).requireGood();
  }
}
