package org.u2sa.gcs.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.common.CommandAck;
import io.dronefleet.mavlink.common.CommandInt;
import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.MavFrame;
import io.dronefleet.mavlink.common.MavResult;
import io.dronefleet.mavlink.minimal.Heartbeat;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.gcs.mavlink.vehicle.Identity;
import org.u2sa.gcs.mavlink.vehicle.VehicleKind;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.MissionReport;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.ArmingState;

/** Goals that take-off and reposition add to the mission. */
class StationGoToTest {
  private static final int TAKE_OFF = 22;
  private static final double GROUND_M = 600.0;

  private static BridgeKit copter(Identity identity) {
    BridgeKit kit = new BridgeKit(identity, VehicleKind.COPTER);
    kit.says(new ArmingState().armed(false));
    kit.says(new StateInformation().x(10.0).y(54.0).z(GROUND_M).psi(1.0));
    kit.says(new ArmingState().armed(true));
    return kit;
  }

  /** A bridge that starts while the vehicle flies 50 m above its home. */
  private static BridgeKit inFlight() {
    BridgeKit kit = new BridgeKit(Identity.ARDUPILOT, VehicleKind.COPTER);
    kit.says(new StateInformation().x(10.0).y(54.0).z(GROUND_M + 50.0).psi(1.0));
    kit.says(new ArmingState().armed(true));
    return kit;
  }

  private static MavResult ofDisarming(BridgeKit kit) {
    kit.command(DISARM, 0);
    return kit.received(CommandAck.class).get(0).result().entry();
  }

  @Test
  void start_inFlight_homeIsUnknownAndDisarmingMustBeForced() {
    BridgeKit kit = inFlight();

    assertThat(ofDisarming(kit)).isEqualTo(MavResult.MAV_RESULT_DENIED);
    assertThat(kit.orders(ArmCommand.class)).isEmpty();
    takeOff(kit, 70.0);
    assertThat(kit.orders(Waypoint.class)).isEmpty();
  }

  @Test
  void start_inFlight_altitudesAreAboveTheMissionsHome() {
    BridgeKit kit = inFlight();
    kit.says(
        new MissionReport()
            .requestId("r")
            .serviceName("MissionManager")
            .goals(List.of(new Waypoint().uid("home").x(10.0).y(54.0).horizontalThreshold(1.0)))
            .homeAltitude(GROUND_M));

    assertThat(ofDisarming(kit)).isEqualTo(MavResult.MAV_RESULT_DENIED);
    takeOff(kit, 70.0);
    assertThat(goal(kit).z()).hasValue(GROUND_M + 70.0);
  }

  @Test
  void disarm_landedAfterAStartInFlight_isObeyed() {
    BridgeKit kit = inFlight();
    kit.says(new ArmingState().armed(false));
    kit.says(new StateInformation().x(10.0).y(54.0).z(GROUND_M).psi(1.0));
    kit.says(new ArmingState().armed(true));
    takeOff(kit, 20.0);

    assertThat(goal(kit).z()).hasValue(GROUND_M + 20.0);
  }

  private static final int DISARM = 400;

  private static void takeOff(BridgeKit kit, double altitudeM) {
    kit.command(TAKE_OFF, 0, 0, 0, 0, 0, 0, altitudeM);
  }

  private static Waypoint goal(BridgeKit kit) {
    return kit.orders(Waypoint.class).get(0);
  }

  @Test
  void takeOff_asArdupilot_altitudeIsAboveHome() {
    BridgeKit kit = copter(Identity.ARDUPILOT);
    takeOff(kit, 20.0);
    assertThat(goal(kit).z()).hasValue(GROUND_M + 20.0);
  }

  @Test
  void takeOff_asPx4_altitudeIsAboveSeaLevel() {
    BridgeKit kit = copter(Identity.PX4);
    takeOff(kit, GROUND_M + 20.0);
    assertThat(goal(kit).z()).hasValue(GROUND_M + 20.0);
  }

  @Test
  void takeOff_copter_isThereAtTheAltitudeOnly() {
    BridgeKit kit = copter(Identity.PX4);
    takeOff(kit, GROUND_M + 20.0);
    assertThat(goal(kit).verticalThreshold()).hasValue(1.0);
  }

  @Test
  void takeOff_toBelowTheVehicle_isRefused() {
    BridgeKit kit = copter(Identity.PX4);
    takeOff(kit, 20.0);
    assertThat(kit.received(CommandAck.class).get(0).result().entry())
        .isEqualTo(MavResult.MAV_RESULT_DENIED);
    assertThat(kit.texts()).contains("20 m above sea level is not above the vehicle");
    assertThat(kit.orders(Waypoint.class)).isEmpty();
  }

  private static Waypoint goTo(BridgeKit kit, double speed) {
    kit.send(
        CommandInt.builder()
            .targetSystem(1)
            .targetComponent(1)
            .frame(MavFrame.MAV_FRAME_GLOBAL)
            .command(MavCmd.MAV_CMD_DO_REPOSITION)
            .param1((float) speed)
            .x(540_010_000)
            .y(100_020_000)
            .z((float) GROUND_M)
            .build());
    Waypoint goal = goal(kit);
    kit.answerMission(true, "pursuing goal");
    return goal;
  }

  @Test
  void reposition_aboveTheTerrain_isRefused() {
    BridgeKit kit = copter(Identity.PX4);
    kit.send(
        CommandInt.builder()
            .targetSystem(1)
            .targetComponent(1)
            .frame(MavFrame.MAV_FRAME_GLOBAL_TERRAIN_ALT_INT)
            .command(MavCmd.MAV_CMD_DO_REPOSITION)
            .x(540_010_000)
            .y(100_020_000)
            .z(40.0f)
            .build());
    assertThat(kit.received(CommandAck.class).get(0).result().entry())
        .isEqualTo(MavResult.MAV_RESULT_DENIED);
    assertThat(kit.texts()).contains("MAV_FRAME 11; expected one above sea level or above home");
    assertThat(kit.orders(Waypoint.class)).isEmpty();
  }

  @Test
  void reposition_withoutSpeedAfterOneWithASpeed_isAnotherGoal() {
    BridgeKit kit = copter(Identity.PX4);
    Waypoint slow = goTo(kit, 0.5);
    Waypoint usual = goTo(kit, -1.0);
    assertThat(slow.speed()).hasValue(0.5);
    assertThat(usual.speed()).isEmpty();
    assertThat(usual.uid()).isNotEqualTo(slow.uid()); // an update keeps what it does not set
  }

  @Test
  void heartbeat_goToAtSpeed_isTheModeOfAGoTo() {
    BridgeKit kit = copter(Identity.ARDUPILOT);
    kit.says(new GoalList().goals(List.of(goTo(kit, 0.5))));
    kit.received(Heartbeat.class);
    kit.advance(1.1);
    assertThat(kit.received(Heartbeat.class).get(0).customMode()).isEqualTo(4); // Guided
  }
}
