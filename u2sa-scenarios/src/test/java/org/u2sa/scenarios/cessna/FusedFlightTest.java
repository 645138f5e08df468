package org.u2sa.scenarios.cessna;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.scenarios.run.CommandLineRun;

/** Flights on noisy GPS, barometer, airspeed, IMU and compass instead of the simulator's truth. */
class FusedFlightTest {
  @TempDir private Path directory;

  private Summary fly(long seed, String... options) {
    Path out = directory.resolve("out");
    String[] all = new String[options.length + 4];
    System.arraycopy(options, 0, all, 4, options.length);
    all[0] = "--estimator";
    all[1] = "fusing";
    all[2] = "--seed";
    all[3] = String.valueOf(seed);
    CommandLineRun run = CommandLineRun.demo("cessna", out, all);
    assertThat(run.exitCode()).as("seed %d: %s%s", seed, run.err(), Summary.in(out)).isZero();
    Summary summary = Summary.in(out);
    summary.requireGood();
    return summary;
  }

  @Test
  void demo_noisySensors_takesOffAndReachesItsWaypoint() {
    fly(1, "--mission", ShortMission.in(directory).toString());
  }

  @Tag("long")
  @ParameterizedTest(name = "seed {0}")
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20})
  void demo_noisySensors_keepsAllBounds(long seed) {
    assertThat(fly(seed).number("waypoints")).isEqualTo(10.0);
  }
}
