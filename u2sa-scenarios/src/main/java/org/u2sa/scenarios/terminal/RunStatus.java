package org.u2sa.scenarios.terminal;

import org.u2sa.scenarios.report.TrackSample;

/**
 * One moment of a run, as people watch it.
 *
 * @param sample where the vehicle truly is, and what it does
 * @param waypoint number of the waypoint it goes to, from 1; 0: none
 * @param waypoints how many the mission has
 * @param waypointName name of the waypoint it goes to; may be empty
 * @param distanceM horizontal distance to it [m]
 * @param elapsedS time of the wall clock since the start [s]
 */
public record RunStatus(
    TrackSample sample,
    int waypoint,
    int waypoints,
    String waypointName,
    double distanceM,
    double elapsedS) {

  /** What the vehicle does, e.g. {@code CLIMB}. */
  String phase() {
    return sample.phase();
  }

  /** Simulated time since the start [s]. */
  double simulatedS() {
    return sample.timeS();
  }
}
