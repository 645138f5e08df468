package org.u2sa.world.modeller;

import java.util.Optional;
import org.u2sa.messages.StateInformation;

/**
 * Time of a measurement and the vehicle state it was taken from.
 *
 * @param micros time of the measurement [µs]
 * @param frame frame of the map to update
 * @param vehicle vehicle state at that time; empty if unknown, in which case the frame is BODY
 */
public record Sighting(long micros, MapFrame frame, Optional<StateInformation> vehicle) {}
