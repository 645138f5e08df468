package org.u2sa.gcs.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.annotations.MavlinkMessageInfo;
import io.dronefleet.mavlink.ardupilotmega.ArdupilotmegaDialect;
import io.dronefleet.mavlink.common.AutopilotVersion;
import io.dronefleet.mavlink.protocol.MavlinkPacket;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.gcs.mavlink.file.RecordingFolder;
import org.u2sa.gcs.mavlink.vehicle.Identity;
import org.u2sa.gcs.mavlink.vehicle.VehicleKind;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.EmergencyStop;

/**
 * A million packets of noise at one session: random bytes, correct packets of any kind with random
 * content, and such with a byte changed.
 */
@Tag("long")
class MillionPacketsTest {
  private static final int PACKETS = 1_000_000;
  private static final int PER_STEP = 100;
  private static final ArdupilotmegaDialect DIALECT = new ArdupilotmegaDialect();
  private static final List<Integer> KINDS =
      IntStream.range(0, 20_000).filter(DIALECT::supports).boxed().collect(Collectors.toList());

  @TempDir Path logs;

  private final Random random = new Random(11);

  private byte[] content(int length) {
    byte[] content = new byte[length];
    random.nextBytes(content);
    return content;
  }

  /** A correct packet; requests for files and parameters come more often than others. */
  private byte[] packet() {
    int kind = random.nextInt(3) == 0 ? 110 : KINDS.get(random.nextInt(KINDS.size()));
    byte[] payload = content(kind == 110 ? 254 : random.nextInt(256));
    if (kind == 110) { // FILE_TRANSFER_PROTOCOL to this vehicle, with an opcode that exists
      payload[0] = 0;
      payload[1] = 1;
      payload[2] = 1;
      payload[5] = (byte) random.nextInt(8);
      payload[6] = (byte) random.nextInt(17);
      if (random.nextBoolean()) {
        byte[] path = "/logs/recording.mcap".getBytes(StandardCharsets.US_ASCII);
        payload[7] = (byte) path.length;
        System.arraycopy(path, 0, payload, 15, path.length);
      }
    }
    Class<?> type = DIALECT.resolve(kind);
    int crc = type.getAnnotation(MavlinkMessageInfo.class).crc();
    return MavlinkPacket.createUnsignedMavlink2Packet(
            random.nextInt(256), 1 + random.nextInt(255), random.nextInt(256), kind, crc, payload)
        .getRawBytes();
  }

  @Test
  void receive_aMillionPackets_nothingIsOrderedAndTheStationIsAnswered() throws IOException {
    Files.write(logs.resolve("recording.mcap"), content(50_000));
    BridgeKit kit =
        new BridgeKit(
                Identity.PX4,
                VehicleKind.ROVER,
                Optional.empty(),
                Optional.of(new RecordingFolder(logs)))
            .ready();
    for (int i = 0; i < PACKETS; i++) {
      byte[] bytes = i % 3 == 0 ? content(1 + random.nextInt(280)) : packet();
      if (i % 3 == 1) {
        bytes[random.nextInt(bytes.length)] ^= (byte) (1 + random.nextInt(255));
      }
      kit.clock.addAndGet(10_000); // within the allowance, so that nothing is dropped unread
      kit.session.receive(bytes, bytes.length, kit.clock.get());
      if (i % PER_STEP == 0) {
        kit.advance(0.1);
        kit.received(Object.class);
        assertThat(kit.orders(ArmCommand.class)).isEmpty();
        assertThat(kit.orders(EmergencyStop.class)).isEmpty();
        kit.published.clear();
      }
    }
    kit.bytes(new byte[600]); // ends a packet that the noise has begun
    kit.advance(60.0);
    kit.received(Object.class);
    kit.command(512, 148);
    assertThat(kit.received(AutopilotVersion.class)).hasSize(1);
    assertThat(new FileStation(kit).download("/logs/recording.mcap"))
        .isEqualTo(Files.readAllBytes(logs.resolve("recording.mcap")));
  }
}
