package org.u2sa.world.modeller;

import java.util.Optional;
import org.u2sa.messages.StateInformation;

/**
 * When something was measured, and from where.
 *
 * @param micros time of the measurement [µs]
 * @param frame of the map that it goes into
 * @param vehicle its state at that time; empty if it is not known, and then the frame is BODY
 */
public record Sighting(long micros, MapFrame frame, Optional<StateInformation> vehicle) {}
