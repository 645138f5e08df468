package org.u2sa.trials.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.mission.Mission;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.RunPlan;
import org.u2sa.sim.world.LocalPlane;

class RunPlansTest {
  private static final LocalPlane PLANE = new LocalPlane(new Geodetic(10.0, 54.0, 30.0));
  private static final RunPlan.Start HOME = new RunPlan.Start(10.0, 54.0, 30.0, 0.0);

  @TempDir private Path folder;

  private Mission mission(String goals) throws IOException {
    Path file = folder.resolve("mission.xml");
    Files.writeString(file, "<mission>" + goals + "</mission>");
    return Mission.load(file, MessageTypes.discovered(), 0.5);
  }

  private RunPlan placed(String goals) throws IOException {
    return RunPlans.placed(Domain.GROUND, mission(goals), HOME, PLANE);
  }

  private static Point place(RunPlan.Waypoint waypoint) {
    return PLANE.point(
        new Geodetic(
            waypoint.longitudeDeg(), waypoint.latitudeDeg(), waypoint.altitudeM().orElse(30.0)));
  }

  @Test
  void placed_waypointsInLocalFrames_areAboutTheOrigin() throws IOException {
    RunPlan plan =
        placed(
            "<waypoint><reference>Local ENU</reference><x>4</x><y>8</y></waypoint>"
                + "<waypoint><reference>Local NED</reference><x>8</x><y>4</y><z>5</z></waypoint>");

    assertThat(place(plan.waypoints().get(0)).distanceTo(Point.of(4.0, 8.0, 0.0)))
        .isCloseTo(0.0, within(0.01));
    assertThat(place(plan.waypoints().get(1)).distanceTo(Point.of(4.0, 8.0, -5.0)))
        .isCloseTo(0.0, within(0.01));
  }

  /** As the planner flies: its own radius around a station without one; no circle without one. */
  @ParameterizedTest
  @CsvSource({"80, 0.5, 100.5, 80.5", "0, 0.5, 0.5, 0.5"})
  void circled_stations_areReachedOnTheCircle(
      double loiterM, double waypoint, double withRadius, double without) throws IOException {
    String place = "<x>10</x><y>54</y>";
    Mission mission =
        mission(
            "<waypoint>%1$s</waypoint><station>%1$s<radius>-100</radius></station><station>%1$s</station>"
                .formatted(place));
    RunPlan plan = RunPlans.of(Domain.AIR, mission, Optional.of(HOME));

    assertThat(RunPlans.circled(plan, mission, loiterM).waypoints())
        .extracting(RunPlan.Waypoint::captureRadiusM)
        .containsExactly(waypoint, withRadius, without);
  }

  @Test
  void placed_goalWithoutAPlace_isNoWaypointOfThePlan() throws IOException {
    RunPlan plan =
        placed(
            "<waypoint><name>a</name><x>10</x><y>54</y></waypoint>"
                + "<objectGoal><name>b</name><objectType>buoy</objectType><within>1</within></objectGoal>"
                + "<payloadDrop><name>c</name><x>10</x><y>54</y><z>50</z><payload>PARCEL</payload></payloadDrop>");

    assertThat(plan.waypoints())
        .as("where an aeroplane releases is not where the payload lands")
        .extracting(RunPlan.Waypoint::name)
        .containsExactly("a");
  }

  @Test
  void placed_objectGoal_interruptsTheLineBeforeTheNextWaypoint() throws IOException {
    String at = "<reference>Local ENU</reference><x>4</x><y>8</y>";
    RunPlan plan =
        placed(
            "<waypoint><name>a</name>"
                + at
                + "</waypoint><objectGoal><name>buoy</name><objectType>buoy</objectType>"
                + "<within>2</within></objectGoal><waypoint><name>b</name>"
                + at
                + "</waypoint>");

    assertThat(plan.others()).containsExactly(new RunPlan.OtherGoal("buoy", 1));
    assertThat(plan.keeping(waypoint -> waypoint.name().equals("b")).others())
        .containsExactly(new RunPlan.OtherGoal("buoy", 0));
  }
}
