package org.u2sa.mavlink;

import io.dronefleet.mavlink.annotations.MavlinkFieldInfo;
import io.dronefleet.mavlink.annotations.MavlinkMessageInfo;

/**
 * AVAILABLE_MODES (435), which the library lacks: one mode of a vehicle. Send-only.
 *
 * @param numberModes number of modes
 * @param modeIndex index of this mode, from 1
 * @param standardMode MAV_STANDARD_MODE; 0: none
 * @param customMode as in HEARTBEAT
 * @param properties MAV_MODE_PROPERTY bits
 * @param modeName up to 34 characters
 */
@MavlinkMessageInfo(id = 435, crc = 134, description = "A mode of the vehicle.")
public record AvailableModes(
    @MavlinkFieldInfo(position = 1, unitSize = 1) int numberModes,
    @MavlinkFieldInfo(position = 2, unitSize = 1) int modeIndex,
    @MavlinkFieldInfo(position = 3, unitSize = 1) int standardMode,
    @MavlinkFieldInfo(position = 4, unitSize = 4) long customMode,
    @MavlinkFieldInfo(position = 5, unitSize = 4) long properties,
    @MavlinkFieldInfo(position = 6, unitSize = 1, arraySize = 35) String modeName) {}
