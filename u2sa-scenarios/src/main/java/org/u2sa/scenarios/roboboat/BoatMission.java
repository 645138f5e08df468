package org.u2sa.scenarios.roboboat;

import java.nio.file.Path;
import java.util.Locale;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.mission.Mission;
import org.u2sa.report.ReportFile;
import org.u2sa.sim.world.LocalPlane;

/** What a team is told of a course: where each task is, roughly, and the colours of its buoys. */
final class BoatMission {
  private static final double BEFORE_M = 4.0; // of a channel's entrance before its first gate

  private final LocalPlane plane = new LocalPlane(BoatCourse.ORIGIN);
  private final BoatCourse course;
  private final StringBuilder text = new StringBuilder();

  private BoatMission(BoatCourse course) {
    this.course = course;
  }

  /** Writes the mission of a course. */
  static Mission write(BoatCourse course, Path file) {
    String text = new BoatMission(course).text();
    ReportFile.writeText(file, out -> out.write(text));
    return Mission.load(file);
  }

  private String text() {
    text.append("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<mission>\n");
    text.append("  <home>").append(place(Point.ORIGIN)).append("<psi>0</psi></home>\n");
    Gate first = course.speedGates().get(0);
    channel("speed gates", first.beyond(-BEFORE_M), false, "<gates>2</gates>");
    channel("channel", course.channel().get(0).beyond(-BEFORE_M), false, "<endBuoy>BLUE</endBuoy>");
    Gate last = course.channel().get(course.channel().size() - 1);
    channel(
        "return", last.beyond(BEFORE_M), true, "<gates>" + course.channel().size() + "</gates>");
    text.append("  <waypoint><name>home</name>").append(place(BoatCourse.HOME));
    text.append("<horizontalThreshold>2</horizontalThreshold></waypoint>\n</mission>\n");
    return text.toString();
  }

  private void channel(String name, Point entrance, boolean back, String end) {
    text.append("  <buoyChannel><name>").append(name).append("</name>").append(place(entrance));
    text.append("<left>").append(back ? BoatCourse.RIGHT : BoatCourse.LEFT).append("</left>");
    text.append("<right>").append(back ? BoatCourse.LEFT : BoatCourse.RIGHT).append("</right>");
    text.append(end).append("</buoyChannel>\n");
  }

  private String place(Point at) {
    Geodetic place = plane.at(at.y(), at.x(), 0.0);
    return String.format(
        Locale.ROOT, "<x>%.9f</x><y>%.9f</y>", place.longitudeDeg(), place.latitudeDeg());
  }
}
