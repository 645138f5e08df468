package org.u2sa.gcs.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.MavFrame;
import io.dronefleet.mavlink.common.MavMissionResult;
import io.dronefleet.mavlink.common.MavMissionType;
import io.dronefleet.mavlink.common.MissionAck;
import io.dronefleet.mavlink.common.MissionClearAll;
import io.dronefleet.mavlink.common.MissionItemInt;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.safety.FenceAction;
import org.u2sa.messages.safety.FenceOrder;
import org.u2sa.messages.safety.FenceState;

/** Fences between a station and the Safety Manager. */
class StationFenceTest {
  private static final MavMissionType FENCE = MavMissionType.MAV_MISSION_TYPE_FENCE;
  private static final int IN = 5001;
  private static final int CIRCLE_OUT = 5004;
  private static final String FILE =
      "<fence><ceiling>300</ceiling><keepIn><centre><x>10</x><y>54</y></centre><radius>80</radius></keepIn>"
          + "<keepOut><corner><x>10</x><y>54</y></corner><corner><x>10.1</x><y>54</y></corner>"
          + "<corner><x>10</x><y>54.1</y></corner></keepOut></fence>";

  private final BridgeKit kit = BridgeKit.rover().ready();
  private final FenceStation station = new FenceStation(() -> kit, FENCE);

  private static MissionItemInt item(int seq, int command, float first, double east, double north) {
    return MissionItemInt.builder()
        .targetSystem(1)
        .targetComponent(1)
        .seq(seq)
        .frame(MavFrame.MAV_FRAME_GLOBAL)
        .command(EnumValue.create(MavCmd.class, command))
        .autocontinue(1)
        .param1(first)
        .x((int) Math.round((BridgeKit.LATITUDE + north) * 1e7))
        .y((int) Math.round((BridgeKit.LONGITUDE + east) * 1e7))
        .missionType(FENCE)
        .build();
  }

  private static List<MissionItemInt> field() {
    return List.of(
        item(0, IN, 3, -0.001, -0.001),
        item(1, IN, 3, 0.0012345, -0.001),
        item(2, IN, 3, 0.0, 0.001),
        item(3, CIRCLE_OUT, 12.3f, 0.0005, 0.0));
  }

  private MissionAck acknowledgement() {
    List<MissionAck> answers = kit.received(MissionAck.class);
    assertThat(answers).hasSize(1);
    return answers.get(0);
  }

  @Test
  void upload_polygonAndCircle_isOrderedAcknowledgedAndReadBackEqual() {
    station.upload(field());
    assertThat(kit.received(MissionAck.class)).as("before the vehicle has answered").isEmpty();

    FenceOrder order = station.answer(true, "in force");

    assertThat(order.action()).isEqualTo(FenceAction.REPLACE);
    assertThat(order.fence().orElseThrow())
        .contains("<keepIn>\n    <corner><x>9.999</x><y>53.999</y></corner>")
        .contains("<radius>12.3</radius>");
    MissionAck answer = acknowledgement();
    assertThat(answer.type().entry()).isEqualTo(MavMissionResult.MAV_MISSION_ACCEPTED);
    assertThat(answer.missionType().entry()).isEqualTo(FENCE);
    assertThat(station.downloaded().toString())
        .isEqualTo(
            field()
                .toString()
                .replace(
                    "targetSystem=1, targetComponent=1", "targetSystem=255, targetComponent=190"));
  }

  @Test
  void upload_refusedBySafetyManager_isAnErrorWithItsReason() {
    station.upload(field());

    station.answer(false, "the vehicle is armed and violates it: outside");

    assertThat(acknowledgement().type().entry()).isEqualTo(MavMissionResult.MAV_MISSION_ERROR);
    assertThat(kit.texts()).contains("violates it: outside");
  }

  @Test
  void upload_overAFenceWithACeiling_keepsTheCeiling() {
    kit.says(new FenceState().fence(FILE).file("fence.xml"));

    station.upload(field());

    assertThat(station.answer(true, "in force").fence().orElseThrow())
        .contains("<ceiling>300.0</ceiling>");
  }

  @Test
  void upload_tornPolygonOrReturnPoint_isRefusedByName() {
    station.upload(
        List.of(item(0, IN, 3, 0, 0), item(1, IN, 3, 0, 1), item(2, CIRCLE_OUT, 3, 1, 1)));
    assertThat(acknowledgement().type().entry())
        .isEqualTo(MavMissionResult.MAV_MISSION_UNSUPPORTED);
    assertThat(kit.texts())
        .contains("fence item 3: does not belong to the polygon that item 1 starts");

    station.upload(List.of(item(0, 5000, 0, 0, 0)));
    assertThat(acknowledgement().type().entry())
        .isEqualTo(MavMissionResult.MAV_MISSION_UNSUPPORTED);
    assertThat(kit.texts()).contains("fence item 1: is a command 5000");
    assertThat(kit.orders(FenceOrder.class)).isEmpty();
  }

  @Test
  void download_ofAFile_isItsAreasAndNamesWhatItemsLack() {
    kit.says(new FenceState().fence(FILE).file("fence.xml"));

    List<MissionItemInt> items = station.downloaded();

    assertThat(items)
        .extracting(each -> each.command().value())
        .containsExactly(5003, 5002, 5002, 5002);
    assertThat(items.get(0).param1()).isEqualTo(80.0f);
    assertThat(kit.texts()).contains("ceiling 300 is not shown");
  }

  @Test
  void download_ofALocalFence_saysWhyItIsNotShown() {
    kit.says(
        new FenceState()
            .file("fence.xml")
            .fence("<fence><reference>Local ENU</reference><keepOut/></fence>"));

    assertThat(station.downloaded()).isEmpty();
    assertThat(kit.texts()).contains("fence not shown").contains("Local ENU");
  }

  @Test
  void clear_ofTheFence_removesItAndClearOfAllTheMissionToo() {
    kit.send(
        MissionClearAll.builder().targetSystem(1).targetComponent(1).missionType(FENCE).build());
    assertThat(station.answer(true, "none").action()).isEqualTo(FenceAction.REMOVE);
    assertThat(acknowledgement().type().entry()).isEqualTo(MavMissionResult.MAV_MISSION_ACCEPTED);

    kit.send(
        MissionClearAll.builder()
            .targetSystem(1)
            .targetComponent(1)
            .missionType(MavMissionType.MAV_MISSION_TYPE_ALL)
            .build());
    station.answer(true, "none");
    assertThat(kit.orders(MissionOrder.class)).hasSize(1);
  }
}
