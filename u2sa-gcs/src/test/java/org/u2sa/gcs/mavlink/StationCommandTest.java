package org.u2sa.gcs.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.common.CommandAck;
import io.dronefleet.mavlink.common.CommandInt;
import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.MavFrame;
import io.dronefleet.mavlink.common.MavResult;
import io.dronefleet.mavlink.common.SetMode;
import io.dronefleet.mavlink.minimal.Heartbeat;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.gcs.mavlink.vehicle.Identity;
import org.u2sa.gcs.mavlink.vehicle.VehicleKind;
import org.u2sa.messages.AircraftState;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.schema.U2SAData;

/** What becomes of a station's commands. */
@SuppressWarnings("deprecation") // stations still send these
class StationCommandTest {
  private static final int ARM = 400;
  private static final int TERMINATE = 185;
  private static final int REPOSITION = 192;
  private static final int CHANGE_SPEED = 178;
  private static final int PX4_LAND = 4 << 16 | 6 << 24;

  private final BridgeKit kit = BridgeKit.rover().ready();

  private MavResult result() {
    List<CommandAck> answers = kit.received(CommandAck.class);
    assertThat(answers).hasSize(1);
    return answers.get(0).result().entry();
  }

  @Test
  void command_disarmWhileArmingIsUnanswered_isNotTakenForItsRepetition() {
    kit.command(400, 1.0);
    kit.command(400, 1.0);
    kit.command(400, 0.0);
    assertThat(kit.orders(ArmCommand.class))
        .extracting(ArmCommand::arm)
        .containsExactly(true, false);
  }

  @Test
  void arm_accepted_isAnsweredWhenTheVehicleIsArmed() {
    kit.command(ARM, 1);
    assertThat(kit.received(CommandAck.class)).isEmpty();
    kit.answerArming(true);
    assertThat(result()).isEqualTo(MavResult.MAV_RESULT_ACCEPTED);
  }

  @Test
  void arm_refused_tellsEveryReasonWhole() {
    String reason =
        "the StateEstimator has not reported a position with a standard deviation below 6 m";
    kit.command(ARM, 1);
    kit.answerArming(false, reason, "no mission");
    assertThat(result()).isEqualTo(MavResult.MAV_RESULT_DENIED);
    assertThat(kit.texts()).contains(reason + "; no mission");
  }

  private static BridgeKit copterAt(double altitudeM) {
    BridgeKit copter = new BridgeKit(Identity.PX4, VehicleKind.COPTER).ready();
    copter.says(new ArmingState().armed(true));
    copter.says(new StateInformation().x(10.0).y(54.0).z(altitudeM).psi(1.0));
    return copter;
  }

  private static long orders(BridgeKit kit) {
    return kit.published.stream().filter(ArmCommand.class::isInstance).count();
  }

  @Test
  void disarm_inTheAir_isObeyedIfForcedOnly() {
    BridgeKit copter = copterAt(30.0);
    copter.command(ARM, 0);
    assertThat(copter.received(CommandAck.class).get(0).result().entry())
        .isEqualTo(MavResult.MAV_RESULT_DENIED);
    assertThat(copter.texts()).contains("not disarmed in the air");
    assertThat(orders(copter)).isZero();
    copter.command(ARM, 0, 21_196);
    assertThat(orders(copter)).isEqualTo(1);
  }

  @Test
  void disarm_onTheGround_isOrdered() {
    BridgeKit copter = copterAt(4.0);
    copter.command(ARM, 0);
    assertThat(orders(copter)).isEqualTo(1);
  }

  @Test
  void disarm_wheelsInTheAir_isRefusedBelowTheHomeToo() {
    BridgeKit plane = copterAt(-20.0);
    plane.says(new AircraftState().weightOnWheels(false));
    plane.command(ARM, 0);
    assertThat(orders(plane)).isZero();
  }

  @Test
  void arm_parameterIsNeither0Nor1_isRefused() {
    kit.command(ARM, Double.NaN);
    assertThat(result()).isEqualTo(MavResult.MAV_RESULT_DENIED);
    assertThat(orders(kit)).isZero();
  }

  @Test
  void arm_repeatedBeforeTheAnswer_isOrderedOnce() {
    kit.command(ARM, 1);
    kit.command(ARM, 1);
    assertThat(kit.published).filteredOn(ArmCommand.class::isInstance).hasSize(1);
    kit.answerArming(true);
    assertThat(result()).isEqualTo(MavResult.MAV_RESULT_ACCEPTED);
  }

  @Test
  void arm_vehicleSilent_isDeniedWithTheReason() {
    kit.command(ARM, 1);
    kit.advance(4.0);
    assertThat(result()).isEqualTo(MavResult.MAV_RESULT_DENIED);
    assertThat(kit.texts()).contains("no answer from the vehicle");
  }

  @Test
  void reposition_fullOfNaN_pauses() {
    double nan = Double.NaN;
    kit.command(REPOSITION, -1, 1, 0, nan, nan, nan, nan);
    assertThat(kit.orders(MissionOrder.class).get(0).action()).isEqualTo(MissionAction.PAUSE);
  }

  @Test
  void reposition_place_goesThereAndStays() {
    kit.send(
        CommandInt.builder()
            .targetSystem(1)
            .targetComponent(1)
            .frame(MavFrame.MAV_FRAME_GLOBAL)
            .command(MavCmd.MAV_CMD_DO_REPOSITION)
            .param1(-1)
            .param4(Float.NaN)
            .x(540_010_000)
            .y(100_020_000)
            .build());
    Waypoint goal = kit.orders(Waypoint.class).get(0);
    assertThat(goal.y().getAsDouble()).isEqualTo(54.001);
    assertThat(goal.x().getAsDouble()).isEqualTo(10.002);
    assertThat(goal.z()).isEmpty(); // a rover's altitude is the ground's
    assertThat(kit.orders(MissionOrder.class).get(0).uid()).hasValue(goal.uid());
  }

  @Test
  void modes_ofBothIdentities_becomeOrders() {
    kit.command(176, 1, 4, 5); // PX4: auto, return
    assertThat(kit.published).filteredOn(MissionOrder.class::isInstance).hasSize(1);
    kit.answerMission(true, "pursuing goal \"home\"");
    assertThat(result()).isEqualTo(MavResult.MAV_RESULT_ACCEPTED);
    kit.send(SetMode.builder().targetSystem(1).customMode(PX4_LAND).build());
    assertThat(kit.orders(MissionOrder.class).get(0).action()).isEqualTo(MissionAction.LAND);
    kit.command(176, 1, 7, 0); // PX4: stabilized
    assertThat(result()).isEqualTo(MavResult.MAV_RESULT_DENIED);
    assertThat(kit.texts()).contains("the vehicle has no mode");

    BridgeKit rover = new BridgeKit(Identity.ARDUPILOT, VehicleKind.ROVER).ready();
    rover.command(176, 1, 4); // ArduPilot: hold
    assertThat(rover.orders(MissionOrder.class).get(0).action()).isEqualTo(MissionAction.PAUSE);
  }

  @Test
  void heartbeat_pausedMission_isHold() {
    kit.received(Heartbeat.class);
    kit.advance(1.0);
    assertThat(kit.received(Heartbeat.class).get(0).customMode()).isEqualTo(4L << 16 | 4L << 24);
    kit.mission("file.xml", List.of(BridgeKit.waypoint("1", 0.001, 0.0)), true);
    kit.advance(1.1);
    assertThat(kit.received(Heartbeat.class).get(0).customMode()).isEqualTo(4L << 16 | 3L << 24);
  }

  @Test
  void missionStart_heldOnTheWayHome_goesBackToTheMission() {
    kit.mission("file.xml", List.of(BridgeKit.waypoint("home", 0.001, 0.0)), true);
    kit.command(300);
    kit.answerMission(true, "resumed at [home]");
    assertThat(kit.received(CommandAck.class)).isEmpty();
    assertThat(kit.order().action()).isEqualTo(MissionAction.RESUME);
    kit.answerMission(true, "resumed at [1]");
    assertThat(result()).isEqualTo(MavResult.MAV_RESULT_ACCEPTED);
    assertThat(kit.published).noneMatch(MissionOrder.class::isInstance);
  }

  @Test
  void missionStart_paused_resumes() {
    kit.mission("file.xml", List.of(BridgeKit.waypoint("1", 0.001, 0.0)), true);
    kit.command(300);
    assertThat(kit.orders(MissionOrder.class).get(0).action()).isEqualTo(MissionAction.RESUME);
  }

  private void confirm(EmergencyStop stop) {
    HealthReport report = new HealthReport().serviceName("Control").status(ServiceStatus.RUNNING);
    kit.says(report.emergencyStops(List.of(stop.identity())));
    kit.advance(0.1);
  }

  @Test
  void terminate_isAcknowledgedWhenAServiceReportsTheStop() {
    kit.command(TERMINATE, 1);
    EmergencyStop stop = kit.orders(EmergencyStop.class).get(0);
    assertThat(stop.active()).isTrue();
    assertThat(kit.received(CommandAck.class)).isEmpty();
    confirm(new EmergencyStop().stopId("somebody else's"));
    assertThat(kit.received(CommandAck.class)).isEmpty();
    confirm(stop);
    assertThat(result()).isEqualTo(MavResult.MAV_RESULT_ACCEPTED);
  }

  private List<MavResult> results() {
    return kit.received(CommandAck.class).stream().map(ack -> ack.result().entry()).toList();
  }

  private <T extends U2SAData> T publishedAt(Class<T> type, long micros) {
    T published = kit.orders(type).get(0);
    published.timestamp(micros);
    return published;
  }

  @Test
  void terminate_vehicleIsSlow_isInProgressAndRepeatedUntilItIsForwardedThenAccepted() {
    kit.command(TERMINATE, 1);
    EmergencyStop stop = publishedAt(EmergencyStop.class, 1L);
    kit.advance(2.0);
    assertThat(results()).hasSizeGreaterThan(2).containsOnly(MavResult.MAV_RESULT_IN_PROGRESS);
    assertThat(kit.orders(EmergencyStop.class)).hasSizeGreaterThan(2).containsOnly(stop);

    kit.says(stop); // forwarded by the broker
    kit.advance(20.0);
    assertThat(kit.orders(EmergencyStop.class)).isEmpty();
    assertThat(results()).containsOnly(MavResult.MAV_RESULT_IN_PROGRESS);
    confirm(stop);
    assertThat(results()).containsExactly(MavResult.MAV_RESULT_ACCEPTED);
  }

  @Test
  void terminate_neverConfirmed_failsAfterHalfAMinuteAndIsNotDenied() {
    kit.command(TERMINATE, 1);
    kit.says(publishedAt(EmergencyStop.class, 1L));
    kit.advance(29.0);
    assertThat(results()).containsOnly(MavResult.MAV_RESULT_IN_PROGRESS);
    kit.advance(2.0);
    assertThat(results())
        .endsWith(MavResult.MAV_RESULT_FAILED)
        .containsOnlyOnce(MavResult.MAV_RESULT_FAILED)
        .doesNotContain(MavResult.MAV_RESULT_DENIED);
    assertThat(kit.texts()).contains("DO_FLIGHTTERMINATION failed: no service");
  }

  @Test
  void terminate_brokerForwardsALaterQuestionOnly_isDeniedForLackOfTheRole() {
    kit.command(TERMINATE, 1);
    publishedAt(EmergencyStop.class, 1L);
    kit.advance(3.5);
    assertThat(results()).containsOnly(MavResult.MAV_RESULT_IN_PROGRESS);
    DiscoveryRequest others = new DiscoveryRequest();
    others.timestamp(5L);
    kit.says(others);
    kit.advance(0.1);
    assertThat(results()).isEmpty();
    kit.says(publishedAt(DiscoveryRequest.class, 2L));
    kit.advance(0.1);
    assertThat(results()).containsExactly(MavResult.MAV_RESULT_DENIED);
    assertThat(kit.texts()).contains("lacks the role operator");
  }

  @Test
  void terminate_connectionIsLost_isPublishedAgainUntilItIsAccepted() {
    kit.isLinkLost = true;
    kit.command(TERMINATE, 1);
    kit.advance(4.0);
    assertThat(results()).containsOnly(MavResult.MAV_RESULT_IN_PROGRESS);
    kit.isLinkLost = false;
    kit.advance(0.6);
    confirm(kit.orders(EmergencyStop.class).get(0));
    assertThat(results()).endsWith(MavResult.MAV_RESULT_ACCEPTED);
  }

  @Test
  void terminate_clearedMeanwhile_isNotPublishedAgain() {
    kit.command(TERMINATE, 1);
    publishedAt(EmergencyStop.class, 1L);
    kit.says(new EmergencyStop().active(false).clears(1L));
    kit.advance(2.0);
    assertThat(kit.orders(EmergencyStop.class)).isEmpty();
  }

  @Test
  void terminate_again_isTheSameStop() {
    kit.command(TERMINATE, 1);
    EmergencyStop first = kit.orders(EmergencyStop.class).get(0);
    confirm(first);
    kit.command(TERMINATE, 1);
    EmergencyStop second = kit.orders(EmergencyStop.class).get(0);
    assertThat(second.identity()).isEqualTo(first.identity());
  }

  @Test
  void takeOff_rover_isRefusedAndCopterClimbs() {
    kit.command(22, 0, 0, 0, 0, 0, 0, 30);
    assertThat(result()).isEqualTo(MavResult.MAV_RESULT_DENIED);
    BridgeKit copter = new BridgeKit(Identity.PX4, VehicleKind.COPTER).ready();
    copter.command(22, 0, 0, 0, 0, 0, 0, 30);
    Waypoint goal = copter.orders(Waypoint.class).get(0);
    assertThat(goal.z().getAsDouble()).isEqualTo(30.0);
    assertThat(goal.x().getAsDouble()).isEqualTo(BridgeKit.LONGITUDE);
  }

  @Test
  void arming_disarmed_isToldByHeartbeat() {
    kit.says(new ArmingState().armed(true));
    kit.received(Heartbeat.class);
    kit.advance(1.1);
    assertThat(kit.received(Heartbeat.class).get(0).baseMode().value() & 128).isEqualTo(128);
  }

  @Test
  void changeSpeed_goalNamedWithMarkup_isOfItToo() {
    kit.mission("file.xml", List.of(BridgeKit.waypoint("pier & gate", 0.001, 0.0)), false);
    kit.command(CHANGE_SPEED, 1, 2.5);

    assertThat(kit.order().goals().orElseThrow())
        .contains("<waypoint><name>pier &amp; gate</name><speed>2.500</speed></waypoint>");
  }
}
