package org.u2sa.gcs.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.common.CommandLong;
import io.dronefleet.mavlink.common.MavCmd;
import java.util.Optional;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.u2sa.gcs.mavlink.vehicle.Identity;
import org.u2sa.gcs.mavlink.vehicle.VehicleKind;
import org.u2sa.mavlink.MavlinkStream;
import org.u2sa.messages.safety.ArmCommand;

/** Packets that no honest station sends: none becomes an order. */
class HostilePacketsProperties {
  private static final MavlinkStream FORGER = new MavlinkStream(BridgeKit.STATION, 190);

  private static CommandLong arm(int target) {
    return CommandLong.builder()
        .targetSystem(target)
        .targetComponent(1)
        .command(MavCmd.MAV_CMD_COMPONENT_ARM_DISARM)
        .param1(1.0f)
        .build();
  }

  private static boolean obeys(BridgeKit kit, byte[] packet) {
    kit.bytes(packet);
    return !kit.orders(ArmCommand.class).isEmpty();
  }

  @Property(tries = 100)
  void receive_mutatedPackets_areNotObeyed(@ForAll long seed) {
    BridgeKit kit = BridgeKit.rover();
    Random random = new Random(seed);
    for (int i = 0; i < 100; i++) {
      byte[] packet = FORGER.encode(arm(1));
      packet[random.nextInt(packet.length)] ^= (byte) (1 + random.nextInt(255));
      kit.session.receive(packet, packet.length, kit.clock.get());
    }
    kit.bytes(new byte[600]); // ends a packet that a wrong length has begun
    assertThat(kit.orders(ArmCommand.class)).isEmpty();
  }

  @Property(tries = 200)
  void receive_randomBytes_areSurvived(@ForAll long seed) {
    BridgeKit kit = BridgeKit.rover().ready();
    Random random = new Random(seed);
    byte[] bytes = new byte[4096];
    random.nextBytes(bytes);
    for (int i = 0; i < bytes.length; i += 64) {
      bytes[i] = (byte) 0xFD; // many beginnings of packets
    }
    kit.published.clear();
    kit.bytes(bytes);
    kit.bytes(new byte[600]); // ends a packet that the noise has begun
    assertThat(obeys(kit, FORGER.encode(arm(1)))).isTrue();
  }

  @Property(tries = 254)
  void receive_forgedSenderOrOtherTarget_isNotObeyed(
      @ForAll @IntRange(min = 2, max = 255) int other) {
    BridgeKit kit = BridgeKit.rover();
    assertThat(obeys(kit, new MavlinkStream(1, 1).encode(arm(1)))).isFalse();
    assertThat(obeys(kit, FORGER.encode(arm(other)))).isFalse();
  }

  @Property(tries = 100)
  void receive_signingOn_onlySignedAndOnlyOnce(@ForAll @IntRange(min = 2, max = 250) int system) {
    BridgeKit kit = new BridgeKit(Identity.PX4, VehicleKind.ROVER, Optional.of("secret"));
    assertThat(obeys(kit, new MavlinkStream(system, 190).encode(arm(1)))).isFalse();
    byte[] signed = kit.station.encode(arm(1));
    assertThat(obeys(kit, signed)).isTrue();
    kit.answerNothing();
    assertThat(obeys(kit, signed)).isFalse();
  }
}
