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
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.gcs.mavlink.vehicle.Identity;
import org.u2sa.gcs.mavlink.vehicle.VehicleKind;
import org.u2sa.messages.safety.FenceAction;
import org.u2sa.messages.safety.FenceOrder;
import org.u2sa.messages.safety.FenceState;

/** Rally points from stations and back; the Safety Manager's side is scripted. */
class StationRallyTest {
  private static final MavMissionType RALLY = MavMissionType.MAV_MISSION_TYPE_RALLY;
  private static final int ABOVE_SEA = 0;
  private static final int ABOVE_HOME = 3;
  private static final String AREA =
      "<keepOut><centre><x>10.01</x><y>54</y></centre><radius>5</radius></keepOut>";

  private BridgeKit kit = new BridgeKit(Identity.PX4, VehicleKind.PLANE).ready(); // home at 3 m
  private final FenceStation station = new FenceStation(() -> kit, RALLY);

  private static MissionItemInt item(int seq, int command, int frame, double z) {
    return MissionItemInt.builder()
        .targetSystem(1)
        .targetComponent(1)
        .seq(seq)
        .frame(EnumValue.create(MavFrame.class, frame))
        .command(EnumValue.create(MavCmd.class, command))
        .autocontinue(1)
        .x((int) Math.round((BridgeKit.LATITUDE + 0.001) * 1.0e7) + seq)
        .y((int) Math.round(BridgeKit.LONGITUDE * 1.0e7))
        .z((float) z)
        .missionType(RALLY)
        .build();
  }

  private MavMissionResult acknowledged() {
    List<MissionAck> answers = kit.received(MissionAck.class);
    assertThat(answers).hasSize(1);
    assertThat(answers.get(0).missionType().entry()).isEqualTo(RALLY);
    return answers.get(0).type().entry();
  }

  @Test
  void upload_besideAFence_keepsItAndIsReadBackEqual() {
    kit.says(new FenceState().fence("<fence>" + AREA + "</fence>").file("fence.xml"));
    List<MissionItemInt> items =
        List.of(item(0, 5100, ABOVE_HOME, 47.1), item(1, 5100, ABOVE_SEA, 60.3));

    station.upload(items);
    assertThat(kit.received(MissionAck.class)).as("before the vehicle has answered").isEmpty();
    String fence = station.answer(true, "in force").fence().orElseThrow();

    assertThat(fence).contains("<keepOut>").contains("<z>50.1</z>").contains("<z>60.3</z>");
    assertThat(acknowledged()).isEqualTo(MavMissionResult.MAV_MISSION_ACCEPTED);
    assertThat(station.downloaded().toString())
        .isEqualTo(
            items
                .toString()
                .replace(
                    "targetSystem=1, targetComponent=1", "targetSystem=255, targetComponent=190"));
  }

  @Test
  void upload_toARover_hasNoAltitudes() {
    kit = BridgeKit.rover().ready();
    kit.says(new FenceState());
    station.upload(List.of(item(0, 5100, ABOVE_HOME, 0.0)));

    assertThat(station.answer(true, "in force").fence().orElseThrow())
        .contains("<rally>")
        .doesNotContain("<z>");
  }

  @Test
  void upload_outsideTheFence_isAnErrorWithTheSafetyManagersReason() {
    kit.says(new FenceState());
    station.upload(List.of(item(0, 5100, ABOVE_SEA, 50.0)));

    station.answer(false, "rally 1 at x 10, y 54: outside the keep-in area");

    assertThat(acknowledged()).isEqualTo(MavMissionResult.MAV_MISSION_ERROR);
    assertThat(kit.texts()).contains("rally points refused: rally 1 at x 10, y 54: outside");
  }

  @ParameterizedTest
  @CsvSource({
    "5100, 10, 50, is in MAV_FRAME 10",
    "16, 0, 50, is a command 16",
    "5100, 3, 0, is not above the home's altitude",
    "5100, 0, NaN, has no altitude",
  })
  void upload_unusableItem_isRefusedByName(int command, int frame, double z, String why) {
    kit.says(new FenceState());
    station.upload(List.of(item(0, command, frame, z)));

    assertThat(acknowledged()).isEqualTo(MavMissionResult.MAV_MISSION_UNSUPPORTED);
    assertThat(kit.texts()).contains("rally point 1: " + why);
    assertThat(kit.orders(FenceOrder.class)).isEmpty();
  }

  @Test
  void upload_overAFenceTooLongToBeSeen_isRefusedAndTheFenceStays() {
    kit.says(new FenceState().file("long.xml"));
    station.upload(List.of(item(0, 5100, ABOVE_SEA, 50.0)));

    assertThat(acknowledged()).isEqualTo(MavMissionResult.MAV_MISSION_ERROR);
    assertThat(kit.orders(FenceOrder.class)).isEmpty();
  }

  @Test
  void clear_ofRallyPoints_keepsTheAreasAndRemovesAFenceWithoutAny() {
    String rally = "<rally><x>10</x><y>54</y></rally>";
    MissionClearAll clear =
        MissionClearAll.builder().targetSystem(1).targetComponent(1).missionType(RALLY).build();
    kit.says(new FenceState().fence("<fence>" + AREA + rally + "</fence>").file("fence.xml"));
    assertThat(station.downloaded()).hasSize(1);
    kit.send(clear);
    assertThat(station.answer(true, "in force").fence().orElseThrow())
        .contains("<keepOut>")
        .doesNotContain("<rally>");
    assertThat(acknowledged()).isEqualTo(MavMissionResult.MAV_MISSION_ACCEPTED);

    kit.says(new FenceState().fence("<fence>" + rally + "</fence>").file("fence.xml"));
    kit.send(clear);
    assertThat(station.answer(true, "none").action()).isEqualTo(FenceAction.REMOVE);
  }
}
