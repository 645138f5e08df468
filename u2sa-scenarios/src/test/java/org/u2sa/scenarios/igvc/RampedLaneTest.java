package org.u2sa.scenarios.igvc;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.scenarios.run.CommandLineRun;
import org.u2sa.sim.camera.Scenery;

/** A straight lane with a ramp as steep as the rules have it, and a barrel just behind it. */
class RampedLaneTest {
  private static final double HALF_M = 1.7;
  private static final double FOOT_M = 4.0;
  private static final double WAY_M = 2.4;
  private static final double TOP_M = 1.0;
  private static final double RISE = 0.15;

  @TempDir private Path directory;

  private static Course course() {
    CourseBuilder builder = new CourseBuilder(Point.ORIGIN, 0.7, false);
    double end = FOOT_M + 2.0 * WAY_M + TOP_M;
    builder.start(Point.ORIGIN, Point.of(1.0, 0.0, 0.0));
    builder.waypoint(Point.of(end + 4.0, 0.0, 0.0));
    for (int side = -1; side <= 1; side += 2) {
      List<Point> edge =
          List.of(Point.of(-2.0, side * HALF_M, 0.0), Point.of(end + 6.0, side * HALF_M, 0.0));
      builder.line(Scenery.LINE, edge);
      builder.line(Course.BOUNDARY, edge);
    }
    builder.barrel(Point.of(end + 2.0, 1.2, 0.0));
    Course level = builder.course("a lane with a ramp");
    List<ObjectDescription> objects = new ArrayList<>(level.objects());
    objects.add(
        builder.ramp(
            List.of(
                Point.of(FOOT_M, 0.0, 0.0),
                Point.of(FOOT_M + WAY_M, 0.0, RISE * WAY_M),
                Point.of(FOOT_M + WAY_M + TOP_M, 0.0, RISE * WAY_M),
                Point.of(end, 0.0, 0.0)),
            2.0 * HALF_M + 0.6));
    return new Course(level.origin(), objects);
  }

  @Test
  void demo_laneWithARamp_isDrivenOverItBetweenItsLines() {
    CommandLineRun run = IgvcRun.of(directory.resolve("run"), course(), 1, "--snapshot-every", "0");
    assertThat(run.figure("waypointsCaptured")).as(run.said()).isEqualTo(1);
    assertThat(run.figure("touches")).as(run.said()).isZero();
    assertThat(run.figure("lineCrossings")).as(run.said()).isZero();
    assertThat(new String(run.file("judge.log"), StandardCharsets.UTF_8))
        .doesNotContain("faster than");
  }
}
