package org.u2sa.scenarios.igvc;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.frame.Point;
import org.u2sa.scenarios.run.CommandLineRun;

/** Positions that are off by 0.5 to 1.5 m for some seconds, over open ground, by laser alone. */
class MultipathTest {
  @TempDir private Path directory;

  private static Course open() {
    CourseBuilder builder = new CourseBuilder(Point.ORIGIN, 0.7, false);
    builder.start(Point.ORIGIN, Point.of(1.0, 0.0, 0.0));
    builder.waypoint(Point.of(20.0, 0.0, 0.0));
    builder.waypoint(Point.of(40.0, 0.0, 0.0));
    return builder.course("open ground");
  }

  @ParameterizedTest
  @ValueSource(longs = {3, 9})
  void demo_reflectedSignals_doNotDrawThePositionAlong(long seed) {
    CommandLineRun run =
        IgvcRun.of(
            directory.resolve("run"),
            open(),
            seed,
            "--camera-dies",
            "0",
            "--set",
            "HealthMonitor:CourseCamera POLICY=ALERT",
            "--snapshot-every",
            "0",
            "--hard",
            "MULTIPATH");
    String log = new String(run.file("logs/StateEstimator.log"), StandardCharsets.UTF_8);
    assertThat(log).as("the test needs a jump").contains("GPS gated");
    assertThat(log).doesNotContain("it was reset to them");
    assertThat(run.figure("waypointsCaptured")).as(run.said()).isEqualTo(2);
  }

  @Tag("long")
  @ParameterizedTest
  @ValueSource(longs = 1)
  void demo_reflectedSignalsOtherSeed_doNotDrawThePositionAlong(long seed) {
    demo_reflectedSignals_doNotDrawThePositionAlong(seed);
  }
}
