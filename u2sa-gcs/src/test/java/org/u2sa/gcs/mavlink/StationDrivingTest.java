package org.u2sa.gcs.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.dronefleet.mavlink.common.CommandAck;
import io.dronefleet.mavlink.common.ManualControl;
import io.dronefleet.mavlink.common.MavResult;
import io.dronefleet.mavlink.common.RcChannelsOverride;
import io.dronefleet.mavlink.minimal.Heartbeat;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.gcs.mavlink.vehicle.VehicleMode;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.safety.ManualDrive;
import org.u2sa.messages.safety.ManualOrder;
import org.u2sa.messages.safety.ManualState;

/** A station that drives a vehicle by its sticks. */
class StationDrivingTest {
  private static final int SET_MODE = 176;
  private static final int MANUAL = 1; // PX4's main mode

  private final BridgeKit kit = BridgeKit.rover().ready();

  private static ManualControl sticks(int x, int y, int z, int r) {
    return ManualControl.builder().target(1).x(x).y(y).z(z).r(r).build();
  }

  private ManualOrder answer(boolean active, String reason) {
    ManualOrder order = kit.orders(ManualOrder.class).get(0);
    ManualState state =
        new ManualState().active(active).operator(order.operator()).requestId(order.requestId());
    kit.says(reason.isEmpty() ? state : state.reason(reason));
    kit.step();
    return order;
  }

  private MavResult result() {
    List<CommandAck> answers = kit.received(CommandAck.class);
    assertThat(answers).hasSize(1);
    return answers.get(0).result().entry();
  }

  private void begin() {
    kit.command(SET_MODE, 1, MANUAL);
    assertThat(answer(true, "").active()).isTrue();
    assertThat(result()).isEqualTo(MavResult.MAV_RESULT_ACCEPTED);
  }

  private ManualDrive drive() {
    kit.advance(0.1);
    List<ManualDrive> drives = kit.orders(ManualDrive.class);
    assertThat(drives).hasSize(1);
    return drives.get(0);
  }

  @Test
  void sticks_withoutTheMode_doNothing() {
    kit.send(sticks(1000, 0, 0, 0));
    kit.send(RcChannelsOverride.builder().targetSystem(1).chan3Raw(2000).build());

    assertThat(kit.orders(ManualDrive.class)).isEmpty();
  }

  @Test
  void sticks_inTheMode_areSharesOfSpeedAndTurn() {
    begin();
    assertThat(kit.vehicle.model.mode()).isEqualTo(VehicleMode.MANUAL);

    kit.send(sticks(0, 250, -500, 0));
    ManualDrive drive = drive();
    assertThat(drive.speedShare().orElseThrow()).isEqualTo(-0.5);
    assertThat(drive.turnShare().orElseThrow()).as("right is negative").isEqualTo(-0.25);

    kit.send(sticks(900, 0, 900, -700));
    ManualDrive beyond = drive();
    assertThat(beyond.speedShare().orElseThrow()).isEqualTo(1.0);
    assertThat(beyond.turnShare().orElseThrow()).isEqualTo(0.7);

    kit.send(sticks(32767, 10, 32767, 32767));
    ManualDrive still = drive();
    assertThat(still.speedShare().orElseThrow()).isZero();
    assertThat(still.turnShare().orElseThrow()).isZero();
  }

  @Test
  void channels_inTheMode_areSharesAndReleasedOnesAreCentred() {
    begin();
    kit.send(
        RcChannelsOverride.builder()
            .targetSystem(1)
            .targetComponent(1)
            .chan1Raw(1300)
            .chan3Raw(1750)
            .build());
    ManualDrive drive = drive();
    assertThat(drive.speedShare().orElseThrow()).isCloseTo(0.5, within(1e-9));
    assertThat(drive.turnShare().orElseThrow()).isCloseTo(0.4, within(1e-9));

    kit.send(RcChannelsOverride.builder().targetSystem(1).chan1Raw(0).chan3Raw(65_535).build());
    assertThat(drive().speedShare().orElseThrow()).isZero();
  }

  @Test
  void sticks_ofAnotherStationOrForAnotherVehicle_doNothing() {
    begin();
    kit.says(new ManualState().active(true).operator("tester station 254"));
    kit.send(sticks(0, 0, 500, 0));
    kit.says(new ManualState().active(true).operator("tester station 255"));
    kit.send(ManualControl.builder().target(2).z(500).build());

    assertThat(kit.orders(ManualDrive.class)).isEmpty();
  }

  @Test
  void mode_refusedByTheVehicle_isDeniedWithItsReason() {
    kit.command(SET_MODE, 1, MANUAL);
    answer(false, "this vehicle cannot be driven by hand");

    assertThat(result()).isEqualTo(MavResult.MAV_RESULT_DENIED);
    assertThat(kit.texts()).contains("this vehicle cannot be driven by hand");
  }

  @Test
  void otherMode_whileDrivenByHand_endsThatFirst() {
    begin();
    kit.command(SET_MODE, 1, 4, 3); // PX4's hold
    assertThat(kit.orders(MissionOrder.class)).isEmpty();
    assertThat(answer(false, "").active()).isFalse();

    assertThat(kit.order().action()).isEqualTo(MissionAction.PAUSE);
    kit.received(Heartbeat.class);
    kit.advance(1.1);
    assertThat(kit.received(Heartbeat.class).get(0).customMode() >> 16).isNotEqualTo(MANUAL);
  }
}
