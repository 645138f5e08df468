package org.u2sa.mavlink;

import io.dronefleet.mavlink.annotations.MavlinkFieldInfo;
import io.dronefleet.mavlink.annotations.MavlinkMessageInfo;

/**
 * CURRENT_MODE (436), which the library lacks. Send-only.
 *
 * @param standardMode MAV_STANDARD_MODE; 0: none
 * @param customMode as in HEARTBEAT
 * @param intendedCustomMode the last ordered mode; 0: unknown
 */
@MavlinkMessageInfo(id = 436, crc = 193, description = "The vehicle's mode.")
public record CurrentMode(
    @MavlinkFieldInfo(position = 1, unitSize = 1) int standardMode,
    @MavlinkFieldInfo(position = 2, unitSize = 4) long customMode,
    @MavlinkFieldInfo(position = 3, unitSize = 4) long intendedCustomMode) {}
