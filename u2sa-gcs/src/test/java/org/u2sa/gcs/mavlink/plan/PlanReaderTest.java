package org.u2sa.gcs.mavlink.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.gcs.mavlink.vehicle.VehicleKind;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.goal.GoalResult;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.MissionReport;

/** Items of the wire as missions of a kind of vehicle, and missions as items. */
class PlanReaderTest {
  private static final Optional<Geodetic> HOME = Optional.of(new Geodetic(10.0, 54.0, 30.0));
  private static final float NONE = Float.NaN;

  /** At 54.001° north, or without a place, 40 m above home. */
  private static MissionItem item(int command, boolean isAt, float p1, float p2, float p3) {
    int x = isAt ? 540_010_000 : 0;
    return new MissionItem(3, command, 1, p1, p2, p3, NONE, x, isAt ? 100_000_000 : 0, 40.0f);
  }

  private static MissionItem waypoint() {
    return item(16, true, 0, 0, 0);
  }

  private static PlanReader read(VehicleKind kind, int first, MissionItem... items) {
    return new PlanReader(kind, HOME, List.of(items), first);
  }

  @ParameterizedTest
  @CsvSource({"0, 1", "1, 2"})
  void read_jump_leadsToTheItemThatTheStationCounts(int first, int target) {
    PlanReader plan =
        read(VehicleKind.ROVER, first, waypoint(), waypoint(), item(177, false, target, 3, 0));

    assertThat(plan.xml()).contains("<repeat from=\"2\" times=\"3\"/>");
    assertThat(plan.names()).containsExactly("1", "2", "");
  }

  @Test
  void read_endlessJump_isALoopOfAllGoals() {
    PlanReader plan =
        read(VehicleKind.ROVER, 0, waypoint(), waypoint(), item(177, false, 0, -1, 0));

    assertThat(plan.xml()).contains("<next>2</next>").contains("<next>1</next>");
  }

  @Test
  void read_speeds_ofEitherTypeUntilTheVehicleChooses() {
    PlanReader plan =
        read(
            VehicleKind.COPTER,
            0,
            item(178, false, 1, 2.3f, -1),
            waypoint(),
            item(178, false, 0, 4, 0),
            waypoint(),
            item(178, false, 1, -2, -1),
            waypoint());

    assertThat(plan.xml().split("<waypoint>"))
        .satisfiesExactly(
            home -> assertThat(home).contains("<home>"),
            first -> assertThat(first).contains("<z>70.0</z><speed>2.3</speed>"),
            second -> assertThat(second).contains("<speed>4.0</speed>"),
            third -> assertThat(third).doesNotContain("speed"));
    assertThat(plan.names()).containsExactly("1", "1", "2", "2", "3", "3");
  }

  @Test
  void read_takeOffHere_climbs() {
    assertThat(read(VehicleKind.COPTER, 0, item(22, false, 0, 0, 0), waypoint()).xml())
        .contains("<takeOff><z>70.0</z></takeOff>");
  }

  @Test
  void read_onTheSurface_hasNoAltitude() {
    assertThat(read(VehicleKind.BOAT, 0, waypoint()).xml().split("</home>")[1])
        .doesNotContain("<z>");
  }

  @ParameterizedTest
  @CsvSource({
    "17, 0, 0, 50, <radius>50.0</radius>",
    "18, 3, 1, -50, <radius>-50.0</radius><turns>3.0</turns><towardsNext>true</towardsNext>",
    "19, 20, 0, 50, <duration>20.0</duration><radius>50.0</radius>",
    "31, 1, 50, 0, <duration>0.0</duration><radius>50.0</radius><towardsNext>true</towardsNext>",
    "16, 20, 0, 0, <duration>20.0</duration>",
    "93, 20, 0, 0, <station><duration>20.0</duration></station>",
  })
  void read_loitersOfAPlaneInMidMission_areStations(
      int command, float first, float second, float third, String fields) {
    PlanReader plan =
        read(VehicleKind.PLANE, 0, item(command, true, first, second, third), waypoint());

    assertThat(plan.xml()).contains("<station>").contains(fields);
    assertThat(plan.details()).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({
    "BOAT, 22, 0, item 1 (MAV_CMD_NAV_TAKEOFF): this vehicle neither takes off nor lands",
    "ROVER, 21, 0, item 1 (MAV_CMD_NAV_LAND): this vehicle neither takes off nor lands",
    "COPTER, 18, 2, item 1 (MAV_CMD_NAV_LOITER_TURNS): this vehicle stays in place",
    "PLANE, 18, 0, item 1 (MAV_CMD_NAV_LOITER_TURNS): 0.0 turns; expected more than 0",
    "PLANE, 93, -1, item 1 (MAV_CMD_NAV_DELAY): until a time of day",
    "PLANE, 206, -5, item 1 (MAV_CMD_DO_SET_CAM_TRIGG_DIST): a distance of -5.0 m",
    "PLANE, 201, 4, item 1 (MAV_CMD_DO_SET_ROI): a view of mode 4.0",
    "COPTER, 178, 5, item 1 (MAV_CMD_DO_CHANGE_SPEED): a speed of type 5.0; expected 0 or 1",
    "COPTER, 16, Infinity, item 1 (MAV_CMD_NAV_WAYPOINT): has a parameter beyond 1000000.0",
    "ROVER, 20, 0, item 1 (MAV_CMD_NAV_RETURN_TO_LAUNCH): nothing comes before it",
  })
  void read_whatTheVehicleCannotDo_isRefused(
      VehicleKind kind, int command, float first, String message) {
    assertThatThrownBy(() -> read(kind, 0, item(command, true, first, 0, 0), waypoint()))
        .isInstanceOf(PlanRefusal.class)
        .hasMessageContaining(message);
  }

  @Test
  void write_branchesAndOptions_areRefusedByName() {
    Waypoint gate = new Waypoint().uid("gate").x(10.0).y(54.0).next(List.of("a", "b"));
    gate.nextIf(GoalResult.FAILED, List.of("a"));
    MissionReport report = new MissionReport().mission("m").goals(List.of(gate));

    assertThatThrownBy(() -> PlanWriter.plan(report.sequence(List.of()), VehicleKind.ROVER, 0))
        .isInstanceOf(PlanRefusal.class)
        .hasMessageContaining("goal \"gate\": has several next goals (and 1 more)");
  }
}
