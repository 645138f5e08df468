package org.u2sa.core.safety;

import java.util.OptionalDouble;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.Waypoint;

/**
 * A place to return to instead of home if it is nearer.
 *
 * @param name "rally 1" is the fence's first
 * @param waypoint position; its threshold is ignored
 * @param place position in the fence's plane: x east, y north [m]
 */
record RallyPoint(String name, Waypoint waypoint, Point place) {
  OptionalDouble altitudeM() {
    return waypoint.z();
  }

  boolean isAt(RallyPoint other) {
    return waypoint.x().equals(other.waypoint.x())
        && waypoint.y().equals(other.waypoint.y())
        && waypoint.z().equals(other.waypoint.z());
  }

  @Override
  public String toString() {
    return String.format(
        "%s at x %s, y %s", name, waypoint.x().orElseThrow(), waypoint.y().orElseThrow());
  }
}
