package org.u2sa.scenarios.igvc;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.messages.frame.Point;
import org.u2sa.scenarios.run.CommandLineRun;
import org.u2sa.sim.camera.Scenery;

/** Straight lanes whose lines are both dashed or worn, with gaps side by side. */
class DashedLaneTest {
  private static final double HALF_M = 1.8;
  private static final double END_M = 22.0;
  private static final double[] LEFT = {-2.0, 6.0, 9.5, 13.0, 16.5, END_M}; // of each dash
  private static final double[] RIGHT = {-2.0, 7.0, 11.0, 15.0, 19.0, END_M};

  @TempDir private Path directory;

  private static CourseBuilder lane() {
    CourseBuilder builder = new CourseBuilder(Point.ORIGIN, 0.7, false);
    builder.start(Point.ORIGIN, Point.of(1.0, 0.0, 0.0));
    for (int side = -1; side <= 1; side += 2) {
      double y = side * HALF_M;
      double[] dashes = side > 0 ? LEFT : RIGHT;
      for (int i = 0; i < dashes.length; i += 2) {
        List<Point> dash = List.of(Point.of(dashes[i], y, 0.0), Point.of(dashes[i + 1], y, 0.0));
        builder.line(i == 2 ? Scenery.WORN_LINE : Scenery.LINE, dash);
      }
      builder.line(Course.BOUNDARY, List.of(Point.of(-2.0, y, 0.0), Point.of(END_M, y, 0.0)));
    }
    builder.waypoint(Point.of(20.0, 0.0, 0.0));
    return builder;
  }

  private CommandLineRun run(Course course) {
    return IgvcRun.of(
        directory.resolve("run"),
        course,
        1,
        "--snapshot-every",
        "0",
        "--minutes",
        "1",
        "--set",
        "PathPlanner:GIVE UP AFTER=25");
  }

  @Test
  void demo_bothLinesDashed_isDrivenBetweenThem() {
    CourseBuilder builder = lane();
    builder.barrel(Point.of(13.0, -1.0, 0.0));
    CommandLineRun run = run(builder.course("a dashed lane"));
    assertThat(run.figure("waypointsCaptured")).as(run.said()).isEqualTo(1);
    assertThat(run.figure("touches")).as(run.said()).isZero();
    assertThat(run.figure("lineCrossings")).as(run.said()).isZero();
  }

  /** Around the barrels a way leads out through one gap and in through another. */
  @Tag("long")
  @Test
  void demo_bothLinesDashedAndNoWayAhead_isNotLeftThroughAGap() {
    CourseBuilder builder = lane();
    for (double y = -HALF_M; y <= HALF_M; y += 0.6) {
      builder.barrel(Point.of(15.0, y, 0.0));
    }
    CommandLineRun run = run(builder.course("a closed dashed lane"));
    assertThat(run.figure("waypointsCaptured")).as(run.said()).isZero();
    assertThat(run.figure("touches")).as(run.said()).isZero();
    assertThat(run.figure("lineCrossings")).as(run.said()).isZero();
  }
}
