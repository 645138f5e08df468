package org.u2sa.gcs.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.common.CommandInt;
import io.dronefleet.mavlink.common.CommandLong;
import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.protocol.MavlinkPacket;
import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.mavlink.MavlinkSigning;
import org.u2sa.mavlink.MavlinkStream;

/** Stops and disarming in every form, found in pieces among other packets and noise. */
class StopSearchTest {
  private final MavlinkStream plain = new MavlinkStream(255, 190);
  private final MavlinkStream keyed =
      new MavlinkStream(255, 190, Optional.of(new MavlinkSigning("key", () -> 1L << 51)));

  private static CommandLong order(MavCmd command, float param1, int target) {
    return CommandLong.builder().targetSystem(target).command(command).param1(param1).build();
  }

  private List<byte[]> stops() {
    CommandLong terminate = order(MavCmd.MAV_CMD_DO_FLIGHTTERMINATION, 1.0f, 1);
    byte[] payload = new byte[33];
    payload[3] = 0x3F;
    payload[2] = (byte) 0x80;
    payload[28] = (byte) 185;
    return List.of(
        plain.encode(terminate),
        plain.encode(order(MavCmd.MAV_CMD_DO_FLIGHTTERMINATION, 1.0f, 0)), // cut after the command
        keyed.encode(terminate),
        plain.encode(order(MavCmd.MAV_CMD_COMPONENT_ARM_DISARM, 0.0f, 1)),
        plain.encode(
            CommandInt.builder()
                .targetSystem(1)
                .command(MavCmd.MAV_CMD_DO_FLIGHTTERMINATION)
                .param1(1.0f)
                .current(1)
                .autocontinue(1)
                .build()),
        MavlinkPacket.createMavlink1Packet(0, 255, 190, 76, 152, payload).getRawBytes());
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 7, 50, 4096})
  void search_stopsAmongOtherPacketsInPieces_findsThemAndNothingElse(int piece) {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    for (byte[] stop : stops()) {
      all.writeBytes(plain.encode(order(MavCmd.MAV_CMD_COMPONENT_ARM_DISARM, 1.0f, 1)));
      all.writeBytes(plain.encode(StationPackets.requestVersion()));
      all.writeBytes(new byte[] {(byte) 0xFE, (byte) 0xFD, 33, 0, (byte) 0xFD, (byte) 0xFF});
      all.writeBytes(stop);
    }
    byte[] bytes = all.toByteArray();
    StopSearch search = new StopSearch();
    List<byte[]> found = new ArrayList<>();
    for (int from = 0; from < bytes.length; from += piece) {
      byte[] part = Arrays.copyOfRange(bytes, from, Math.min(bytes.length, from + piece));
      search.search(part, part.length, found::add);
    }
    // the same packets, but for sequence numbers and timestamps
    assertThat(found).hasSameSizeAs(stops());
    assertThat(found.stream().map(each -> each.length))
        .containsExactlyElementsOf(stops().stream().map(each -> each.length).toList());
  }
}
