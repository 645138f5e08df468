package org.u2sa.scenarios.run;

import java.util.List;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.scenarios.report.PlannedWaypoint;
import org.u2sa.scenarios.report.RunPlan;

/** The straights between the waypoints of a plan, the first from home. */
final class PlannedLegs {
  private final List<PlannedWaypoint> waypoints;
  private final RunPlan plan;

  PlannedLegs(RunPlan plan) {
    this.plan = plan;
    waypoints = plan.waypoints();
  }

  /** Distance of a place from the leg's line [m], right of it positive; 0 where there is no leg. */
  double crossTrackM(int leg, double longitudeDeg, double latitudeDeg) {
    if (leg < 0 || leg >= waypoints.size() || (leg == 0 && plan.home().isEmpty())) {
      return 0.0;
    }
    Geodetic from =
        leg == 0
            ? new Geodetic(plan.home().get().longitudeDeg(), plan.home().get().latitudeDeg(), 0.0)
            : place(waypoints.get(leg - 1));
    Point to = from.nedOf(place(waypoints.get(leg)));
    Point here = from.nedOf(new Geodetic(longitudeDeg, latitudeDeg, 0.0));
    double length = Math.hypot(to.x(), to.y());
    return length == 0.0 ? 0.0 : (to.x() * here.y() - to.y() * here.x()) / length;
  }

  /** Horizontal distance of a place from the leg's end [m]; 0 where there is no leg. */
  double distanceM(int leg, double longitudeDeg, double latitudeDeg) {
    if (leg < 0 || leg >= waypoints.size()) {
      return 0.0;
    }
    return place(waypoints.get(leg)).distanceM(new Geodetic(longitudeDeg, latitudeDeg, 0.0));
  }

  private static Geodetic place(PlannedWaypoint waypoint) {
    return new Geodetic(waypoint.longitudeDeg(), waypoint.latitudeDeg(), 0.0);
  }
}
