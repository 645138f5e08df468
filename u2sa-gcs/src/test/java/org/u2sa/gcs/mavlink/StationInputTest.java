package org.u2sa.gcs.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.common.CommandLong;
import io.dronefleet.mavlink.common.MavCmd;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.gcs.mavlink.vehicle.Identity;
import org.u2sa.gcs.mavlink.vehicle.VehicleKind;
import org.u2sa.mavlink.MavlinkSigning;
import org.u2sa.mavlink.MavlinkStream;
import org.u2sa.messages.safety.EmergencyStop;

/** Floods of stops by senders without the key, who may forge the station's address. */
class StationInputTest {
  private static final int MORE_THAN_THE_ALLOWANCES = 3_000;
  private static final CommandLong STOP = command(MavCmd.MAV_CMD_DO_FLIGHTTERMINATION, 1.0f);
  private static final CommandLong DISARM = command(MavCmd.MAV_CMD_COMPONENT_ARM_DISARM, 0.0f);

  private final BridgeKit kit =
      new BridgeKit(Identity.PX4, VehicleKind.ROVER, Optional.of("secret"));

  private static CommandLong command(MavCmd command, float param1) {
    return CommandLong.builder().targetSystem(1).command(command).param1(param1).build();
  }

  private void flood(byte[] packet) {
    for (int i = 0; i < MORE_THAN_THE_ALLOWANCES; i++) {
      kit.session.receive(packet, packet.length, kit.clock.get());
    }
    kit.published.clear();
  }

  private void assertThatAStopIsObeyed() {
    kit.send(STOP);
    assertThat(kit.orders(EmergencyStop.class)).hasSize(1);
  }

  @Test
  void take_stopsSignedWithAnotherKey_leaveRoomForTheStationsStop() {
    Optional<MavlinkSigning> guess = Optional.of(new MavlinkSigning("guess", kit.clock::get));
    flood(new MavlinkStream(BridgeKit.STATION, 190, guess).encode(STOP));

    assertThatAStopIsObeyed();
  }

  @Test
  void take_stopsWithoutASignature_leaveRoomForTheStationsStop() {
    flood(new MavlinkStream(BridgeKit.STATION, 190).encode(STOP));

    assertThatAStopIsObeyed();
  }

  @Test
  void take_recordedDisarmingAgainAndAgain_leavesRoomForTheStationsStop() {
    byte[] recorded = kit.station.encode(DISARM);
    kit.bytes(recorded);
    flood(recorded);

    assertThatAStopIsObeyed();
  }
}
