package org.u2sa.mavlink;

import io.dronefleet.mavlink.annotations.MavlinkFieldInfo;
import io.dronefleet.mavlink.annotations.MavlinkMessageInfo;

/**
 * AVAILABLE_MODES_MONITOR (437), which the library lacks. Send-only.
 *
 * @param sequence changes with the modes, which makes stations request them again
 */
@MavlinkMessageInfo(id = 437, crc = 30, description = "Version of the list of modes.")
public record AvailableModesMonitor(@MavlinkFieldInfo(position = 1, unitSize = 1) int sequence) {}
