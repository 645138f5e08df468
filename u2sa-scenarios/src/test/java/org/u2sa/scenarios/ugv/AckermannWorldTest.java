package org.u2sa.scenarios.ugv;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.scenarios.run.CommandLineRun;
import org.u2sa.testkit.Repository;

/**
 * The truck with steered wheels among obstacles that only its laser sees, led by PLANNER HYBRID.
 * Judged by truth.
 */
class AckermannWorldTest {
  private static final double METRES_PER_DEG_LATITUDE = 110_852.0;
  private static final double METRES_PER_DEG_LONGITUDE = 97_264.0; // at 29.19 deg north

  private static final double POSITION_ERROR_M = 0.05;

  @TempDir private Path directory;

  private CommandLineRun drive(long seed, String world, String... more) {
    List<String> options =
        new ArrayList<>(List.of("--vehicle", "ackermann", "--seed", String.valueOf(seed)));
    options.addAll(List.of("--world", file(world)));
    options.addAll(List.of(more));
    return CommandLineRun.demo(
        "ugv", directory.resolve("out" + seed), options.toArray(new String[0]));
  }

  private static String file(String name) {
    return Repository.root().resolve("missions/ugv").resolve(name).toString();
  }

  private CommandLineRun park(long seed) {
    return drive(seed, "parking-world.xml", "--mission", file("parking.xml"));
  }

  /** Way driven with the rear first on a leg [m]. */
  private static double backwardsM(CommandLineRun run, int leg) {
    double backwards = 0.0;
    double[] before = null;
    for (String line : new String(run.track(), StandardCharsets.UTF_8).lines().skip(1).toList()) {
      String[] cells = line.split(",");
      double[] now = {Double.parseDouble(cells[1]), Double.parseDouble(cells[2])};
      if (before != null && Integer.parseInt(cells[7]) == leg) {
        double east = (now[0] - before[0]) * METRES_PER_DEG_LONGITUDE;
        double north = (now[1] - before[1]) * METRES_PER_DEG_LATITUDE;
        double rad = Math.toRadians(Double.parseDouble(cells[4]));
        backwards += Math.max(0.0, -(east * Math.sin(rad) + north * Math.cos(rad)));
      }
      before = now;
    }
    return backwards;
  }

  /** Reached as far as the vehicle can know: its position is off by some centimetres. */
  private static void requireReached(CommandLineRun run, double... thresholdsM) {
    assertThat(run.exitCode()).as(run.out() + run.err()).isLessThanOrEqualTo(ExitCode.FAILED);
    JsonNode summary = run.summary();
    assertThat(summary.get("goalsCompleted").asInt()).isEqualTo(thresholdsM.length);
    assertThat(summary.get("contacts").asInt()).isZero();
    for (int i = 0; i < thresholdsM.length; i++) {
      assertThat(summary.get("perWaypoint").get(i).get("missM").asDouble())
          .as("waypoint %s", i + 1)
          .isLessThan(thresholdsM[i] + POSITION_ERROR_M);
    }
  }

  private static void requireBackedOut(CommandLineRun run) {
    requireReached(run, 0.5, 0.3, 0.4, 0.5); // thresholds of parking.xml
    assertThat(backwardsM(run, 2)).as("backwards out of the bay").isGreaterThan(0.5);
    assertThat(backwardsM(run, 3)).as("backwards out of the alley").isGreaterThan(0.5);
  }

  @Test
  void demo_bayAndBlindAlley_backsOutAndTurnsRound() {
    requireBackedOut(park(1));
  }

  @Tag("long")
  @ParameterizedTest
  @ValueSource(longs = {2, 3, 4, 5, 6, 7, 8, 9, 10, 11})
  void demo_bayAndBlindAlleyManySeeds_backsOutAndTurnsRound(long seed) {
    requireBackedOut(park(seed));
  }

  @Tag("long")
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
  void demo_obstaclesOnEveryLeg_areDrivenAround(long seed) {
    requireReached(drive(seed, "obstructed.xml", "--loops", "1"), 0.5, 0.5, 0.5, 0.5, 0.5, 0.5);
  }
}
