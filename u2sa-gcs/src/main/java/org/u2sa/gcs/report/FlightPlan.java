package org.u2sa.gcs.report;

import java.util.List;
import java.util.Optional;

/**
 * What was to be flown.
 *
 * @param home where the flight starts; empty: where the first sample is
 * @param waypoints in the order of flight
 * @param fence corners of the area in which to stay; empty: none was set
 */
public record FlightPlan(Optional<Home> home, List<PlannedWaypoint> waypoints, List<Corner> fence) {

  /** A corner of the fence [deg, east and north +]. */
  public record Corner(double longitudeDeg, double latitudeDeg) {}

  public FlightPlan {
    waypoints = List.copyOf(waypoints);
    fence = List.copyOf(fence);
  }

  /** Without a fence. */
  public FlightPlan(Optional<Home> home, List<PlannedWaypoint> waypoints) {
    this(home, waypoints, List.of());
  }

  /** The same within a fence. */
  public FlightPlan within(List<Corner> corners) {
    return new FlightPlan(home, waypoints, corners);
  }
}
