package org.u2sa.scenarios.igvc;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.frame.Point;
import org.u2sa.scenarios.run.CommandLineRun;
import org.u2sa.sim.camera.Scenery;

/**
 * A lane of 11 m that turns aside, with a barrel, and a straight one with a flag: by camera and
 * laser, judged by truth.
 */
class ShortCourseTest {
  private static final double HALF_M = 1.8;
  private static final double LANE_HALF_M = 2.0;

  @TempDir private Path directory;

  /** The straight way to the waypoint leads over the line: whoever does not see it crosses it. */
  private static Course course() {
    CourseBuilder builder = new CourseBuilder(Point.ORIGIN, 0.7, false);
    builder.start(Point.ORIGIN, Point.of(1.0, 0.0, 0.0));
    for (int side = -1; side <= 1; side += 2) {
      double y = side * HALF_M;
      double bend = 5.0 - 0.7 * y;
      List<Point> edge =
          List.of(
              Point.of(-2.0, y, 0.0), Point.of(bend, y, 0.0), Point.of(bend + 5.0, y + 5.0, 0.0));
      builder.line(Scenery.LINE, edge);
      builder.line(Course.BOUNDARY, edge);
    }
    builder.barrel(Point.of(4.0, -1.1, 0.0));
    builder.waypoint(Point.of(8.6, 3.6, 0.0));
    return builder.course("a short lane");
  }

  @Test
  void demo_laneThatTurnsAside_isDrivenBetweenItsLines() {
    CommandLineRun run = IgvcRun.of(directory.resolve("run"), course(), 1, "--snapshot-every", "5");
    requireClean(run);
    assertThat(run.file("snapshots/005.png")).isNotEmpty();
  }

  /** A straight lane with a flag to one side of its middle: the other side is the wider. */
  private static Course laneWithFlag(boolean red) {
    CourseBuilder builder = new CourseBuilder(Point.ORIGIN, 0.7, false);
    builder.start(Point.ORIGIN, Point.of(1.0, 0.0, 0.0));
    for (int side = -1; side <= 1; side += 2) {
      List<Point> edge =
          List.of(Point.of(-2.0, side * LANE_HALF_M, 0.0), Point.of(12.0, side * LANE_HALF_M, 0.0));
      builder.line(Scenery.LINE, edge);
      builder.line(Course.BOUNDARY, edge);
    }
    builder.flag(Point.of(6.0, red ? 0.15 : -0.15, 0.0), red);
    builder.waypoint(Point.of(10.0, 0.0, 0.0));
    return builder.course("a lane with a flag");
  }

  @ParameterizedTest
  @ValueSource(booleans = false)
  void demo_flagWithTheWiderWayOnTheWrongSide_isPassedOnTheRightOne(boolean red) {
    CommandLineRun run =
        IgvcRun.of(
            directory.resolve("run"),
            laneWithFlag(red),
            1,
            "--set",
            "PathPlanner:PASS SIDES=red flag: LEFT, blue flag: RIGHT");
    requireClean(run);
    assertThat(run.figure("flagsOnWrongSide")).as(run.said()).isZero();
    CommandLineRun without = IgvcRun.of(directory.resolve("other"), laneWithFlag(red), 1);
    assertThat(without.figure("flagsOnWrongSide")).as(without.said()).isEqualTo(1);
  }

  @Tag("long")
  @ParameterizedTest
  @ValueSource(booleans = true)
  void demo_otherFlagWithTheWiderWayOnTheWrongSide_isPassedOnTheRightOne(boolean red) {
    demo_flagWithTheWiderWayOnTheWrongSide_isPassedOnTheRightOne(red);
  }

  private static void requireClean(CommandLineRun run) {
    assertThat(run.figure("waypointsCaptured")).as(run.said()).isEqualTo(1);
    assertThat(run.figure("touches")).as(run.said()).isZero();
    assertThat(run.figure("lineCrossings")).as(run.said()).isZero();
  }

  @Test
  void demo_cameraDiesOnTheWay_standsBetweenItsLines() {
    standsBetweenItsLines("--camera-dies");
  }

  @Tag("long")
  @Test
  void demo_laserDiesOnTheWay_standsBetweenItsLines() {
    standsBetweenItsLines("--lidar-dies");
  }

  private void standsBetweenItsLines(String dies) {
    CommandLineRun run = IgvcRun.of(directory.resolve("run"), course(), 1, dies, "5");
    assertThat(run.figure("waypointsCaptured")).as(run.said()).isZero();
    assertThat(run.figure("touches")).as(run.said()).isZero();
    assertThat(run.figure("lineCrossings")).as(run.said()).isZero();
    assertThat(new String(run.file("judge.log"), StandardCharsets.UTF_8))
        .contains("stood still for more than a minute");
  }

  @Tag("long")
  @Test
  void demo_ofTheSameSeed_isTheSameToTheByte() {
    CommandLineRun one = IgvcRun.of(directory.resolve("one"), course(), 3);
    CommandLineRun other = IgvcRun.of(directory.resolve("other"), course(), 3);
    assertThat(one.file("track.csv")).isEqualTo(other.file("track.csv"));
    assertThat(one.file("judge.log")).isEqualTo(other.file("judge.log"));
  }
}
