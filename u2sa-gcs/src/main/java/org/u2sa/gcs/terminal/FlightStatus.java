package org.u2sa.gcs.terminal;

/**
 * One moment of a flight, as people watch it.
 *
 * @param phase what the vehicle does, e.g. {@code CLIMB}; not empty
 * @param waypoint number of the waypoint flown to, from 1; 0: none
 * @param waypoints how many the mission has
 * @param waypointName name of the waypoint flown to; may be empty
 * @param distanceM horizontal distance to it [m]
 * @param altitudeM altitude above mean sea level [m]
 * @param airspeedMps calibrated airspeed [m/s]
 * @param bankRad bank [rad], right wing down positive
 * @param crossTrackM distance from the planned track [m], right of it positive
 * @param simulatedS simulated time since the start [s]
 * @param elapsedS time of the wall clock since the start [s]
 */
public record FlightStatus(
    String phase,
    int waypoint,
    int waypoints,
    String waypointName,
    double distanceM,
    double altitudeM,
    double airspeedMps,
    double bankRad,
    double crossTrackM,
    double simulatedS,
    double elapsedS) {}
