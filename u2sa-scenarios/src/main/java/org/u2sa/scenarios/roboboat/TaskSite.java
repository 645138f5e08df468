package org.u2sa.scenarios.roboboat;

import java.util.List;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;

/**
 * Site of an optional task (thesis 4.2) and its objects.
 *
 * @param station where a boat stops for it, north and east of the course's origin [m]
 * @param headingRad heading from the station to the objects, clockwise from north
 * @param sought type of the task's target object
 * @param objects all objects, in LOCAL_ENU of the origin
 */
record TaskSite(
    Task task, Point station, double headingRad, String sought, List<ObjectDescription> objects) {
  /** Straight way from the station of a dock to the berth [m]. */
  static final double DOCK_WAY_M = 7.0;

  enum Task {
    /** Shoot darts through a hoop of a given colour. */
    HOOP(new Outlook(45.0, 0.9)),
    /** Press the button beside the submerged white buoy. */
    BUTTON(new Outlook(30.0, 0.8)),
    /** Enter a dock, and have the sub-vehicle fetch the puck from it. */
    DOCK(new Outlook(110.0, 0.7)),
    /** Report the position of the hottest target. */
    TARGET(new Outlook(12.0, 0.95));

    private final Outlook outlook;

    Task(Outlook outlook) {
      this.outlook = outlook;
    }

    Outlook outlook() {
      return outlook;
    }
  }

  /**
   * A team's expectation of a task.
   *
   * @param expectedS time at the station
   * @param probability probability of success, 0…1
   */
  record Outlook(double expectedS, double probability) {}

  /** The first object of the sought type. */
  ObjectDescription object() {
    return objects.stream()
        .filter(each -> each.objectType().equals(sought))
        .findFirst()
        .orElseThrow();
  }

  /** Position relative to a station: ahead along its heading, and to the right [m]. */
  static Point at(Point station, double headingRad, double ahead, double right) {
    double cos = Math.cos(headingRad);
    double sin = Math.sin(headingRad);
    return Point.of(
        station.x() + ahead * cos - right * sin, station.y() + ahead * sin + right * cos, 0.0);
  }
}
