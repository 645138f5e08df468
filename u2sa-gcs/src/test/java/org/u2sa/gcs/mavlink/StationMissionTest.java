package org.u2sa.gcs.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.MavFrame;
import io.dronefleet.mavlink.common.MavMissionResult;
import io.dronefleet.mavlink.common.MavMissionType;
import io.dronefleet.mavlink.common.MissionAck;
import io.dronefleet.mavlink.common.MissionClearAll;
import io.dronefleet.mavlink.common.MissionCount;
import io.dronefleet.mavlink.common.MissionItemInt;
import io.dronefleet.mavlink.common.MissionRequestInt;
import io.dronefleet.mavlink.common.MissionRequestList;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.gcs.mavlink.vehicle.Identity;
import org.u2sa.gcs.mavlink.vehicle.VehicleKind;
import org.u2sa.messages.goal.ObjectGoal;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;

/** Missions between a station and the Mission Manager. */
class StationMissionTest {
  private final BridgeKit kit = BridgeKit.rover().ready();

  private static MissionItemInt item(int seq, int command, double north, float... parameters) {
    return MissionItemInt.builder()
        .targetSystem(1)
        .targetComponent(1)
        .seq(seq)
        .frame(MavFrame.MAV_FRAME_GLOBAL_RELATIVE_ALT_INT)
        .command(EnumValue.create(MavCmd.class, command))
        .autocontinue(1)
        .param1(parameters.length > 0 ? parameters[0] : 0.0f)
        .param2(parameters.length > 1 ? parameters[1] : 0.0f)
        .param3(0.0f)
        .param4(Float.NaN)
        .x((int) Math.round((BridgeKit.LATITUDE + north) * 1e7))
        .y((int) Math.round(BridgeKit.LONGITUDE * 1e7))
        .z(12.5f)
        .missionType(MavMissionType.MAV_MISSION_TYPE_MISSION)
        .build();
  }

  private static void upload(BridgeKit kit, List<MissionItemInt> items) {
    kit.send(MissionCount.builder().targetSystem(1).targetComponent(1).count(items.size()).build());
    for (int i = 0; i < items.size(); i++) {
      assertThat(kit.received(MissionRequestInt.class))
          .extracting(MissionRequestInt::seq)
          .containsExactly(i);
      kit.send(items.get(i));
    }
  }

  private static List<MissionItemInt> downloaded(BridgeKit kit) {
    kit.send(MissionRequestList.builder().targetSystem(1).targetComponent(1).build());
    int count = kit.received(MissionCount.class).get(0).count();
    List<MissionItemInt> items = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      kit.send(MissionRequestInt.builder().targetSystem(1).targetComponent(1).seq(i).build());
      items.addAll(kit.received(MissionItemInt.class));
    }
    return items;
  }

  private MavMissionResult result() {
    List<MissionAck> answers = kit.received(MissionAck.class);
    assertThat(answers).hasSize(1);
    return answers.get(0).type().entry();
  }

  @Test
  void upload_waypoints_replacesTheMissionAndIsReadBackEqual() {
    List<MissionItemInt> items =
        List.of(
            item(0, 178, 0.0, 1, 1.5f), // speed
            item(1, 16, 0.001, 0, 3),
            item(2, 16, 0.002),
            item(3, 177, 0.0, 1, 2), // back to item 1, twice
            item(4, 16, 0.003),
            item(5, 20, 0.0)); // return
    upload(kit, items);
    assertThat(kit.received(MissionAck.class)).isEmpty(); // until the Mission Manager has answered
    MissionOrder order = kit.order();
    assertThat(order.action()).isEqualTo(MissionAction.REPLACE);
    assertThat(order.now()).isFalse(); // not armed: nothing moves by an upload
    assertThat(order.goals().orElseThrow())
        .contains("<home><x>10.0</x><y>54.0</y><z>3.0</z></home>")
        .contains(
            "<waypoint><next>2</next><x>10.0</x><y>54.001</y><horizontalThreshold>3.0</horizontalThreshold><speed>1.5</speed></waypoint>")
        .contains("<repeat from=\"1\" times=\"2\"/>")
        .contains("<next>home</next>");
    kit.answerMission(true, "paused at 2");
    assertThat(kit.received(MissionAck.class)).isEmpty(); // until it can be read back
    kit.mission(
        order.file().orElseThrow(),
        List.of(
            BridgeKit.waypoint("1", 0.0, 0.001),
            BridgeKit.waypoint("2", 0.0, 0.002),
            BridgeKit.waypoint("3", 0.0, 0.003)),
        true);
    kit.step();
    assertThat(result()).isEqualTo(MavMissionResult.MAV_MISSION_ACCEPTED);
    List<MissionItemInt> back = downloaded(kit);
    assertThat(back).hasSize(items.size());
    for (int i = 0; i < items.size(); i++) {
      MissionItemInt sent = items.get(i);
      assertThat(back.get(i).toString().replace("current=1", "current=0"))
          .isEqualTo(
              sent.toString()
                  .replace(
                      "targetSystem=1, targetComponent=1",
                      "targetSystem=255, targetComponent=190"));
    }
  }

  @Test
  void upload_inexpressibleItem_isRefusedByName() {
    upload(kit, List.of(item(0, 16, 0.001), item(1, 205, 0.001)));
    assertThat(result()).isEqualTo(MavMissionResult.MAV_MISSION_UNSUPPORTED);
    assertThat(kit.texts())
        .contains("mission item 2 (MAV_CMD_DO_MOUNT_CONTROL): no goal can express that");
    assertThat(kit.orders(MissionOrder.class)).isEmpty();
  }

  @Test
  void upload_refusedByTheMissionManager_isAnErrorWithItsReason() {
    upload(kit, List.of(item(0, 16, 0.001)));
    kit.answerMission(false, "the mission's goals would be too long to publish");
    assertThat(result()).isEqualTo(MavMissionResult.MAV_MISSION_ERROR);
    assertThat(kit.texts()).contains("too long to publish");
  }

  @Test
  void upload_lostRequestAndRepeatedItem_isCompleted() {
    kit.send(MissionCount.builder().targetSystem(1).targetComponent(1).count(2).build());
    kit.received(MissionRequestInt.class);
    kit.advance(0.6);
    assertThat(kit.received(MissionRequestInt.class))
        .extracting(MissionRequestInt::seq)
        .containsExactly(0);
    kit.send(item(0, 16, 0.001));
    kit.send(item(0, 16, 0.001));
    kit.send(item(1, 16, 0.002));
    assertThat(kit.orders(MissionOrder.class)).hasSize(1);
  }

  @Test
  void upload_lastItemRepeatedAsTheAnswerWasLost_isAnsweredAgain() {
    upload(kit, List.of(item(0, 16, 0.001), item(1, 205, 0.001)));
    assertThat(result()).isEqualTo(MavMissionResult.MAV_MISSION_UNSUPPORTED);
    kit.send(item(0, 16, 0.001));
    assertThat(kit.received(MissionAck.class)).isEmpty();
    kit.send(item(1, 205, 0.001));
    assertThat(result()).isEqualTo(MavMissionResult.MAV_MISSION_UNSUPPORTED);
    upload(kit, List.of(item(0, 16, 0.001)));
    kit.send(item(0, 16, 0.001)); // the Mission Manager has not answered yet
    assertThat(kit.received(MissionAck.class)).isEmpty();
  }

  @Test
  void upload_abandoned_isCancelled() {
    kit.send(MissionCount.builder().targetSystem(1).targetComponent(1).count(2).build());
    kit.advance(22.0);
    assertThat(result()).isEqualTo(MavMissionResult.MAV_MISSION_OPERATION_CANCELLED);
  }

  @Test
  void upload_tooManyItems_hasNoSpace() {
    kit.send(MissionCount.builder().targetSystem(1).targetComponent(1).count(1001).build());
    assertThat(result()).isEqualTo(MavMissionResult.MAV_MISSION_NO_SPACE);
  }

  @Test
  void download_ofTheMissionManagersGoals_asPx4AndAsArduPilot() {
    List<MissionItemInt> px4 = downloaded(kit);
    assertThat(px4).extracting(MissionItemInt::x).containsExactly(540_000_000, 540_010_000);
    assertThat(px4).extracting(MissionItemInt::current).containsExactly(1, 0);
    List<MissionItemInt> ardupilot =
        downloaded(new BridgeKit(Identity.ARDUPILOT, VehicleKind.ROVER).ready());
    assertThat(ardupilot).hasSize(3); // home first
    assertThat(ardupilot.get(0).y()).isEqualTo(100_000_000);
  }

  @Test
  void download_otherGoalClass_isRefusedByName() {
    kit.mission(
        "file.xml",
        List.of(
            BridgeKit.waypoint("1", 0.0, 0.0),
            new ObjectGoal().uid("buoy").objectType("Buoy").within(2.0)),
        false);
    assertThat(downloaded(kit)).isEmpty();
    assertThat(kit.texts())
        .contains("goal \"buoy\": is of type ObjectGoal, which no item can express");
  }

  @Test
  void clear_holdsHere() {
    kit.send(MissionClearAll.builder().targetSystem(1).targetComponent(1).build());
    MissionOrder order = kit.order();
    kit.answerMission(true, "paused at held");
    kit.mission(order.file().orElseThrow(), List.of(BridgeKit.waypoint("held", 0.0, 0.0)), true);
    kit.step();
    assertThat(result()).isEqualTo(MavMissionResult.MAV_MISSION_ACCEPTED);
    assertThat(downloaded(kit)).isEmpty();
  }

  @Test
  void upload_radiusWithoutEnd_isAnsweredByARefusal() {
    BridgeKit kit = BridgeKit.rover().ready();
    upload(kit, List.of(item(0, 16, 0.001, 0, Float.POSITIVE_INFINITY)));
    assertThat(kit.received(MissionAck.class)).hasSize(1);
    assertThat(kit.orders(MissionOrder.class)).isEmpty();
  }
}
