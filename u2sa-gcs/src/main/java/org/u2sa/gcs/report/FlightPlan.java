package org.u2sa.gcs.report;

import java.util.List;
import java.util.Optional;

/**
 * What was to be flown.
 *
 * @param home where the flight starts; empty: where the first sample is
 * @param waypoints in the order of flight
 */
public record FlightPlan(Optional<Home> home, List<PlannedWaypoint> waypoints) {

  public FlightPlan {
    waypoints = List.copyOf(waypoints);
  }
}
