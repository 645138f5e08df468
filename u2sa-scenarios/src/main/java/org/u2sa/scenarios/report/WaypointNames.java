package org.u2sa.scenarios.report;

/** How waypoints are called in pictures. */
final class WaypointNames {

  private WaypointNames() {}

  /** The number from 1 before the name, unless the name is empty or already has the number. */
  static String numbered(int index, PlannedWaypoint waypoint) {
    String number = String.valueOf(index + 1);
    if (waypoint.name().isEmpty()) {
      return number;
    }
    boolean hasNumber = waypoint.name().matches("(.*\\D)?0*" + number + "(\\D.*)?");
    return hasNumber ? waypoint.name() : number + " " + waypoint.name();
  }
}
