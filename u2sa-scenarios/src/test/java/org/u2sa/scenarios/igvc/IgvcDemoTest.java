package org.u2sa.scenarios.igvc;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.shape.PolyLine;
import org.u2sa.mission.Mission;
import org.u2sa.report.score.RunPlan;
import org.u2sa.sim.world.LocalPlane;
import org.u2sa.trials.run.DemoFrame;
import org.u2sa.world.xml.WorldFile;

/** The vehicle goes for the middle of a waypoint; the rules count two metres. */
class IgvcDemoTest {
  @TempDir private Path directory;

  @Test
  void plan_ofACoursesMission_countsWaypointsByTheRulesNotByWhatTheVehicleAimsAt() {
    Mission mission =
        CourseMission.write(
            CourseGenerator.course(1),
            new Geodetic(-83.0, 42.0, 290.0),
            directory.resolve("mission.xml"));

    List<RunPlan.Waypoint> waypoints = new DemoFrame().plan(new IgvcDemo(), mission).waypoints();

    assertThat(waypoints).hasSize(4).allMatch(each -> each.captureRadiusM() == 2.0);
    assertThat(mission.goals()).allMatch(goal -> ((Waypoint) goal).horizontalThreshold() < 1.0);
  }

  @Test
  void writeKnown_courseWithAFence_tellsStartBoxAndFenceOnTheEarth() {
    Course course = CourseGenerator.course(1);
    Geodetic origin = new Geodetic(-83.0, 42.0, 290.0);
    Path file = CourseMission.writeKnown(course, origin, directory.resolve("known.xml"));

    List<ObjectDescription> known = WorldFile.load(file).objects();

    assertThat(known)
        .extracting(ObjectDescription::objectType)
        .containsExactly("start box", "fence 1");
    LocalPlane plane = new LocalPlane(origin);
    List<Point> told =
        ((PolyLine) known.get(1))
            .points().stream().map(point -> plane.point(Geodetic.of(point))).toList();
    List<Point> fence = course.fences().get(0).points();
    assertThat(told).hasSameSizeAs(fence);
    for (int i = 0; i < fence.size(); i++) {
      assertThat(told.get(i).x()).isCloseTo(fence.get(i).x(), offset(1.0e-3));
      assertThat(told.get(i).y()).isCloseTo(fence.get(i).y(), offset(1.0e-3));
    }
  }
}
