package org.u2sa.scenarios.igvc;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.PolyLine;
import org.u2sa.mission.Mission;
import org.u2sa.report.ReportFile;
import org.u2sa.sim.world.LocalPlane;

/**
 * Information that a team receives about a course: start, waypoints, the box around the start and
 * the fences around the field.
 */
final class CourseMission {
  /**
   * Makes the vehicle aim for the centre of a waypoint, regardless of the size of the judge's
   * circle.
   */
  private static final double THRESHOLD_M = 0.9;

  /**
   * Forward and right [m]: from 1 m behind the vehicle to where the camera sees the lines, and half
   * of the narrowest lane to each side. In the body frame, independent of GPS errors.
   */
  private static final String START_BOX = "2.2 -1.5; -1.0 -1.5; -1.0 1.5; 2.2 1.5";

  private CourseMission() {}

  /**
   * Writes the mission.
   *
   * @param origin origin of the course
   */
  static Mission write(Course course, Geodetic origin, Path file) {
    LocalPlane plane = new LocalPlane(origin);
    Course.Start start = course.start();
    StringBuilder text = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    text.append("<!-- Waypoints of IGVC ").append(course.origin()).append(". -->\n<mission>\n");
    text.append("  <home>").append(place(plane, start.eastM(), start.northM()));
    text.append(
        String.format(Locale.ROOT, "<psi>%.6f</psi></home>\n", Math.toDegrees(start.headingRad())));
    for (Course.Goal goal : course.goals()) {
      text.append("  <waypoint><name>").append(goal.name()).append("</name>");
      text.append(place(plane, goal.eastM(), goal.northM()));
      double threshold = Math.min(THRESHOLD_M, goal.radiusM());
      text.append("<horizontalThreshold>").append(threshold);
      text.append("</horizontalThreshold></waypoint>\n");
    }
    ReportFile.writeText(file, out -> out.write(text.append("</mission>\n").toString()));
    return Mission.load(file);
  }

  private static String place(LocalPlane plane, double eastM, double northM) {
    Geodetic at = plane.at(eastM, northM, 0.0);
    return String.format(
        Locale.ROOT, "<x>%.9f</x><y>%.9f</y>", at.longitudeDeg(), at.latitudeDeg());
  }

  /**
   * Writes a world with prior knowledge that prevents the vehicle from driving backwards out of the
   * start, through the lines beside it, which the camera cannot see yet, or off the field.
   */
  static Path writeKnown(Course course, Geodetic origin, Path file) {
    LocalPlane plane = new LocalPlane(origin);
    StringBuilder text = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<world>\n");
    text.append(wall("start box", "<reference>BODY</reference>", START_BOX));
    for (PolyLine fence : course.fences()) {
      text.append(wall(fence.uid(), "", coordinates(plane, fence.points())));
    }
    ReportFile.writeText(file, out -> out.write(text.append("</world>\n").toString()));
    return file;
  }

  private static String coordinates(LocalPlane plane, List<Point> along) {
    StringBuilder points = new StringBuilder();
    for (Point corner : along) {
      Geodetic at = plane.at(corner.x(), corner.y(), 0.0);
      points.append(points.length() == 0 ? "" : "; ");
      points.append(String.format(Locale.ROOT, "%.9f %.9f", at.longitudeDeg(), at.latitudeDeg()));
    }
    return points.toString();
  }

  private static String wall(String uid, String reference, String points) {
    return "  <PolyLine><uid>"
        + uid
        + "</uid><type>"
        + uid
        + "</type>"
        + reference
        + "<level>AVOID_ALWAYS</level><points>"
        + points
        + "</points><width>0.08</width></PolyLine>\n";
  }
}
