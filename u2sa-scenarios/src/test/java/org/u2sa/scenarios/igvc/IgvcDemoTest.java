package org.u2sa.scenarios.igvc;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.core.mission.Mission;
import org.u2sa.messages.Waypoint;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.scenarios.report.RunPlan;
import org.u2sa.scenarios.run.DemoFrame;

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
}
