package org.u2sa.report.picture;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.WaypointResult;

/**
 * A waypoint on the map. Several at the same position, as in a mission with laps, are merged, with
 * the first one's name.
 *
 * @param index index of the first one in the plan, from 0
 * @param waypoint the first one
 * @param times number of merged ones
 * @param capturedTimes number of those that were captured
 */
record WaypointSign(int index, RunPlan.Waypoint waypoint, int times, int capturedTimes) {

  static List<WaypointSign> of(List<WaypointResult> results) {
    List<WaypointSign> signs = new ArrayList<>();
    for (int i = 0; i < results.size(); i++) {
      WaypointResult result = results.get(i);
      int known = at(signs, result.waypoint());
      int captured = result.captured() ? 1 : 0;
      if (known < 0) {
        signs.add(new WaypointSign(i, result.waypoint(), 1, captured));
      } else {
        WaypointSign first = signs.get(known);
        signs.set(
            known,
            new WaypointSign(
                first.index(),
                first.waypoint(),
                first.times() + 1,
                first.capturedTimes() + captured));
      }
    }
    return signs;
  }

  private static int at(List<WaypointSign> signs, RunPlan.Waypoint waypoint) {
    for (int i = 0; i < signs.size(); i++) {
      RunPlan.Waypoint other = signs.get(i).waypoint();
      if (other.longitudeDeg() == waypoint.longitudeDeg()
          && other.latitudeDeg() == waypoint.latitudeDeg()) {
        return i;
      }
    }
    return -1;
  }

  /** Whether all were captured. */
  boolean captured() {
    return capturedTimes == times;
  }

  /** Whether none was captured. */
  boolean missed() {
    return capturedTimes == 0;
  }

  /** How often it was captured, if neither always nor never; otherwise empty. */
  String share() {
    return captured() || missed()
        ? ""
        : String.format(Locale.ROOT, " (%d of %d times)", capturedTimes, times);
  }

  /** Name prefixed with its number from 1, unless the name is empty or already contains it. */
  String numberedName() {
    String number = String.valueOf(index + 1);
    if (waypoint.name().isEmpty()) {
      return number;
    }
    boolean hasNumber = waypoint.name().matches("(.*\\D)?0*" + number + "(\\D.*)?");
    return hasNumber ? waypoint.name() : number + " " + waypoint.name();
  }
}
