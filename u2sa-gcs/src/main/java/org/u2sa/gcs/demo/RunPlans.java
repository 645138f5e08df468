package org.u2sa.gcs.demo;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.core.mission.Mission;
import org.u2sa.gcs.report.Domain;
import org.u2sa.gcs.report.Home;
import org.u2sa.gcs.report.PlannedWaypoint;
import org.u2sa.gcs.report.RunPlan;
import org.u2sa.messages.GoalInformation;
import org.u2sa.messages.Waypoint;
import org.u2sa.messages.frame.Geodetic;

/** A mission as reports and screens see it. */
public final class RunPlans {
  private RunPlans() {}

  /**
   * The plan of a mission on the earth.
   *
   * @param home where the vehicle starts
   */
  public static RunPlan of(Domain domain, Mission mission, Optional<Home> home) {
    List<PlannedWaypoint> waypoints = new ArrayList<>();
    for (GoalInformation goal : mission.goals()) {
      if (goal instanceof Waypoint waypoint) {
        waypoints.add(
            new PlannedWaypoint(
                waypoint.uid(),
                waypoint.x().orElseThrow(),
                waypoint.y().orElseThrow(),
                waypoint.z(),
                waypoint.horizontalThreshold(),
                waypoint.verticalThreshold()));
      }
    }
    return new RunPlan(domain, home, waypoints);
  }

  /** The way from home past all waypoints [m]. */
  static double lengthM(RunPlan plan) {
    double length = 0.0;
    Optional<Geodetic> from =
        plan.home().map(home -> new Geodetic(home.longitudeDeg(), home.latitudeDeg(), 0.0));
    for (PlannedWaypoint waypoint : plan.waypoints()) {
      Geodetic to = new Geodetic(waypoint.longitudeDeg(), waypoint.latitudeDeg(), 0.0);
      length += from.map(to::distanceM).orElse(0.0);
      from = Optional.of(to);
    }
    return length;
  }
}
