package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.MissionReport;
import org.u2sa.messages.mission.MissionRequest;

/**
 * A multirotor above level ground whose map ends 300 m to the north and the south of the origin,
 * and has no heights between 100 m and 200 m to the south of it.
 */
class TerrainLimitsTest extends PlannedVehicle {
  private static final int CELLS = 61;

  @TempDir Path folder;
  private final TestVehicle aircraft =
      new TestVehicle() {
        @Override
        void step(double dtS, Optional<NavigationPoint> point) {} // it is put where it shall be
      };

  @BeforeEach
  void start() throws IOException {
    double south = place(-300.0, 0.0).latitudeDeg();
    double cellDeg = 2.0 * (TestVehicle.ORIGIN.latitudeDeg() - south) / (CELLS - 1);
    double west = TestVehicle.ORIGIN.longitudeDeg() - CELLS / 2 * cellDeg;
    StringBuilder text = new StringBuilder("ncols " + CELLS + "\nnrows " + CELLS + "\n");
    text.append("xllcenter " + west + "\nyllcenter " + south);
    text.append("\ncellsize " + cellDeg + "\nNODATA_value -9999\n");
    for (int row = CELLS - 1; row >= 0; row--) {
      boolean isGap = row > 10 && row < 20;
      text.append((isGap ? "-9999 " : "0 ").repeat(CELLS)).append('\n');
    }
    Path map = Files.writeString(folder.resolve("ground.asc"), text);
    kit.with("PLANNER", "GRID").with("VERTICAL CLEARANCE", 3.0).with("EVASION CLIMB", 2.0);
    kit.with("CLEARANCE", 2.0).with("PLANNING CELL", 1.0).with("PLANNING SPAN", 200.0);
    kit.with("PLANNED SPEED", 3.0).with("TERRAIN", map.toString());
  }

  private static Geodetic place(double north, double east) {
    return TestVehicle.ORIGIN.fromNed(Point.of(north, east, 0.0));
  }

  private void fly() {
    kit.start(PathPlanner::new);
    aircraft.altitude = 20.0;
  }

  private static Waypoint at(String uid, double north, double east) {
    Geodetic place = place(north, east);
    Waypoint goal = new Waypoint().horizontalThreshold(2.0);
    goal.uid(uid).referenceFrame(ReferenceFrame.GLOBAL);
    return goal.x(place.longitudeDeg()).y(place.latitudeDeg()).z(20.0);
  }

  /** The Mission Manager's goals and its answer to the request for all of the mission. */
  private void mission(GoalInformation... goals) {
    List<GoalInformation> all = new ArrayList<>(Arrays.asList(goals));
    all.add(at("home", 0.0, 0.0));
    kit.publish(
        Channels.GOALS, new GoalList().goals(List.of(goals[0])).upcoming(List.of(goals[1])));
    MissionRequest request =
        (MissionRequest)
            kit.latest(Channels.MISSION).filter(MissionRequest.class::isInstance).orElseThrow();
    kit.publish(
        Channels.MISSION,
        new MissionReport()
            .requestId(request.requestId())
            .serviceName("MissionManager")
            .mission("mission.xml")
            .goals(all)
            .finished(all.stream().map(goal -> 0.0).toList())
            .current(List.of(goals[0].uid()))
            .upcoming(List.of(goals[1].uid()))
            .sequence(Arrays.stream(goals).map(GoalInformation::uid).toList()));
  }

  private void stand(double north, double east) {
    aircraft.north = north;
    aircraft.east = east;
    kit.publish(Channels.OBJECTS, new ObjectList()); // an empty sky
    kit.publish(Channels.STATE, aircraft.state());
    kit.advance(0.1);
  }

  @Test
  void see_newMission_namesGoalsOutsideTheMapWithDistanceAndWaysThatLeaveIt() {
    fly();
    mission(at("a", 0.0, 100.0), at("b", 250.0, 0.0), at("c", 400.0, 0.0), at("d", -250.0, 0.0));

    assertThat(logged("ground.asc does not cover goal \"c\" (100 m beyond its edge); ground"))
        .isOne();

    mission(at("e", 50.0, 0.0), at("f", -250.0, 0.0));

    assertThat(logged("ground.asc does not cover the way from \"e\" to \"f\"; ground")).isOne();
  }

  @Test
  void see_missionOnTheMap_saysNothing() {
    fly();
    mission(at("a", 250.0, 0.0), at("b", 250.0, 100.0));
    stand(0.0, 0.0);
    stand(250.0, 0.0);

    assertThat(logged("ground.asc")).isZero();
  }

  @Test
  void see_vehicleLeavesTheMapAndReturns_warnsEachTimeItLeaves() {
    fly();
    mission(at("a", 250.0, 0.0), at("b", 250.0, 100.0));
    stand(310.0, 0.0);
    stand(320.0, 0.0);

    assertThat(logged("does not cover the ground (10 m beyond its edge)")).isOne();

    stand(290.0, 0.0);
    stand(-150.0, 0.0);

    assertThat(logged("does not cover the ground (in a gap)")).isOne();
  }

  /** An order that is no part of the mission, such as GOTO a place. */
  @Test
  void see_routeLeavesTheMap_isSaidWithDistance() {
    fly();
    stand(260.0, 0.0);
    goals(at("a", 360.0, 0.0));
    stand(260.0, 0.0);

    assertThat(logged("the route to goal \"a\" leaves TERRAIN")).isOne();
    assertThat(logged("ground.asc after 40 m; ground")).isOne();
  }

  /** Such as one whose search areas alone need the map. */
  @Test
  void see_vehicleThatDoesNotKeepClearOfTheGround_saysNothing() {
    kit.with("VERTICAL CLEARANCE", 0.0);
    fly();
    goals(at("a", 360.0, 0.0));
    stand(310.0, 0.0);

    assertThat(logged("ground.asc")).isZero();
    assertThat(kit.latest(Channels.MISSION)).isEmpty();
  }
}
