package org.u2sa.gcs.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.dronefleet.mavlink.common.CommandAck;
import io.dronefleet.mavlink.common.ManualControl;
import io.dronefleet.mavlink.common.MavResult;
import io.dronefleet.mavlink.common.RcChannelsOverride;
import io.dronefleet.mavlink.minimal.Heartbeat;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.gcs.mavlink.vehicle.VehicleMode;
import org.u2sa.mavlink.MavlinkStream;
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

    kit.send(sticks(0, 0, 0, 0));
    assertThat(drive().speedShare().orElseThrow()).isZero();
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
    kit.send(ManualControl.builder().target(2).x(500).build());
    kit.station = new MavlinkStream(254, 190);
    kit.send(sticks(500, 0, 0, 0));

    assertThat(kit.orders(ManualDrive.class)).isEmpty();
  }

  @Test
  void sticks_ofAStationWithTheSameIdOnAnotherConnection_doNothing() {
    begin();
    StationSession other = new StationSession(kit.vehicle, Optional.empty());
    byte[] packet = kit.station.encode(sticks(500, 0, 0, 0));
    other.receive(packet, packet.length, kit.clock.get());
    RcChannelsOverride channels =
        RcChannelsOverride.builder().targetSystem(1).chan3Raw(2000).build();
    byte[] override = kit.station.encode(channels);
    other.receive(override, override.length, kit.clock.get());
    assertThat(kit.orders(ManualDrive.class)).isEmpty();

    kit.send(sticks(500, 0, 0, 0));
    assertThat(drive().speedShare().orElseThrow()).isEqualTo(0.5);
  }

  @Test
  void throttle_thatRestsAt500_drivesBothWaysFromThere() {
    begin();
    kit.send(sticks(0, 0, 500, 0));
    assertThat(drive().speedShare().orElseThrow()).as("a released stick").isZero();
    kit.send(sticks(0, 0, 750, 0));
    assertThat(drive().speedShare().orElseThrow()).isEqualTo(0.5);
    kit.send(sticks(0, 0, 0, 0));
    assertThat(drive().speedShare().orElseThrow()).isEqualTo(-1.0);
  }

  @Test
  void throttle_notAtRestWhenTheModeBegins_isIgnoredUntilTheModeBeginsAgain() {
    begin();
    kit.send(sticks(100, 0, 800, 0));
    assertThat(drive().speedShare().orElseThrow()).isEqualTo(0.1);
    assertThat(kit.texts()).contains("throttle ignored");
    kit.says(new ManualState().active(false));
    kit.send(sticks(0, 0, 0, 0));
    begin();
    kit.send(sticks(0, 0, 0, 0));
    assertThat(drive().speedShare().orElseThrow()).isZero();
    kit.send(sticks(0, 0, 800, 0));
    assertThat(drive().speedShare().orElseThrow()).isEqualTo(0.8);
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
