package org.u2sa.scenarios.report;

import java.util.OptionalDouble;

/**
 * How well one waypoint was met, by truth. All three numbers are empty if the waypoint never was
 * the target.
 *
 * @param waypoint as planned
 * @param missM smallest horizontal distance to it while it was the target [m]
 * @param altitudeErrorM altitude at that moment less the planned one [m], too high positive; empty
 *     also if none was planned
 * @param timeS simulated time of that moment [s]
 * @param captured whether at some moment while it was the target the vehicle was within the capture
 *     radius and, if there is one, within the vertical threshold
 */
public record WaypointResult(
    PlannedWaypoint waypoint,
    OptionalDouble missM,
    OptionalDouble altitudeErrorM,
    OptionalDouble timeS,
    boolean captured) {}
