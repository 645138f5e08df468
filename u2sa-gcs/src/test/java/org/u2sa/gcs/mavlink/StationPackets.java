package org.u2sa.gcs.mavlink;

import io.dronefleet.mavlink.common.CommandLong;
import io.dronefleet.mavlink.common.MavCmd;

/** Packets of a station, and a count of the answers to them. */
final class StationPackets {
  private static final int COMMAND_ACK = 77;
  private static final int HEADER = 10;
  private static final int CHECKSUM = 2;

  private StationPackets() {}

  static CommandLong requestVersion() {
    return CommandLong.builder()
        .targetSystem(1)
        .targetComponent(1)
        .command(MavCmd.MAV_CMD_REQUEST_MESSAGE)
        .param1(148)
        .build();
  }

  /** Number of COMMAND_ACK in bytes that begin with a packet; the last may be cut off. */
  static int acknowledgements(byte[] bytes) {
    int count = 0;
    int at = 0;
    while (at + HEADER <= bytes.length && (bytes[at] & 0xFF) == 0xFD) {
      count += bytes[at + 7] == COMMAND_ACK && bytes[at + 8] == 0 ? 1 : 0;
      at += HEADER + (bytes[at + 1] & 0xFF) + CHECKSUM;
    }
    return count;
  }
}
