package org.u2sa.scenarios.report;

import java.util.List;
import java.util.Optional;

/**
 * What was to be flown or driven.
 *
 * @param domain by what kind of vehicle
 * @param home where the run starts; empty: where the first sample is
 * @param waypoints in the order of the run
 * @param fence corners of the area in which to stay; empty: none was set
 */
public record RunPlan(
    Domain domain, Optional<StartPlace> home, List<PlannedWaypoint> waypoints, List<Corner> fence) {

  /** A corner of the fence [deg, east and north +]. */
  public record Corner(double longitudeDeg, double latitudeDeg) {}

  public RunPlan {
    waypoints = List.copyOf(waypoints);
    fence = List.copyOf(fence);
  }

  /** Without a fence. */
  public RunPlan(Domain domain, Optional<StartPlace> home, List<PlannedWaypoint> waypoints) {
    this(domain, home, waypoints, List.of());
  }

  /** The same within a fence. */
  public RunPlan within(List<Corner> corners) {
    return new RunPlan(domain, home, waypoints, corners);
  }
}
