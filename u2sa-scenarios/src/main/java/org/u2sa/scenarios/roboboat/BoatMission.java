package org.u2sa.scenarios.roboboat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.mission.Mission;
import org.u2sa.report.ReportFile;
import org.u2sa.scenarios.roboboat.gate.Gate;
import org.u2sa.scenarios.roboboat.subvehicle.QuadrotorOnDeck;
import org.u2sa.sim.world.LocalPlane;

/**
 * Information given to a team: the approximate position of each task, and the colours. After the
 * channel and after each task, all other tasks and the return are current goals; the planner
 * chooses (OPTIONS is ANY).
 */
final class BoatMission {
  /** Name of the sub-vehicle's goal. */
  static final String FETCH = "fetch";

  private static final double BEFORE_M = 4.0; // from a channel's entrance to its first gate
  private static final double HOMEWARD_MPS = 0.6; // assumed speed on the way home
  private static final double RESERVE_S = 60.0;
  private static final double GRIP_M = 0.25; // height of the quadrotor above the deck, at the puck

  private final LocalPlane plane = new LocalPlane(BoatCourse.ORIGIN);
  private final BoatCourse course;
  private final boolean gatesOnly;
  private final StringBuilder text = new StringBuilder();

  private BoatMission(BoatCourse course, boolean gatesOnly) {
    this.course = course;
    this.gatesOnly = gatesOnly;
  }

  /**
   * Writes the mission of a course.
   *
   * @param gatesOnly whether to omit the optional tasks and give the number of gates instead of the
   *     buoy at the end
   */
  static Mission write(BoatCourse course, boolean gatesOnly, Path file) {
    String text = new BoatMission(course, gatesOnly).text();
    ReportFile.writeText(file, out -> out.write(text));
    return Mission.load(file);
  }

  private String text() {
    text.append("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<mission>\n");
    text.append("  <home>").append(place(Point.ORIGIN)).append("<psi>0</psi></home>\n");
    text.append("  <timeLimit next=\"return\">");
    text.append(Math.round(endByS(course.end()))).append("</timeLimit>\n");
    if (!course.speedGates().isEmpty()) {
      Gate first = course.speedGates().get(0);
      channel("speed gates", first, false, "<next>channel</next><gates>2</gates>");
    }
    if (gatesOnly) {
      channel("channel", course.channel().get(0), false, "<next>return</next>" + gates());
    } else {
      channel("channel", course.channel().get(0), false, next("") + "<endBuoy>BLUE</endBuoy>");
      course.sites().forEach(this::task);
    }
    Gate last = course.channel().get(course.channel().size() - 1);
    channel(
        "return",
        new Gate(last.right(), last.left()),
        true,
        "<next>home way</next><fallback>true</fallback>" + gates());
    text.append("  <waypoint><name>home way</name>");
    text.append(place(course.home()));
    text.append("<horizontalThreshold>2</horizontalThreshold></waypoint>\n</mission>\n");
    return text.toString();
  }

  private String gates() {
    return "<gates>" + course.channel().size() + "</gates>";
  }

  private void channel(String name, Gate first, boolean back, String rest) {
    text.append("  <buoyChannel>").append(name(name)).append(place(first.beyond(-BEFORE_M)));
    text.append("<left>").append(back ? BoatCourse.RIGHT : BoatCourse.LEFT).append("</left>");
    text.append("<right>").append(back ? BoatCourse.LEFT : BoatCourse.RIGHT).append("</right>");
    text.append(rest).append("</buoyChannel>\n");
  }

  private void task(TaskSite site) {
    String kind =
        switch (site.task()) {
          case HOOP -> "hulaHoop";
          case BUTTON -> "pressButton";
          case DOCK -> "dockBoat";
          case TARGET -> "findTarget";
        };
    boolean isDock = site.task() == TaskSite.Task.DOCK;
    TaskSite.Outlook outlook = site.task().outlook();
    String types = site.sought() + (site.task() == TaskSite.Task.BUTTON ? ", white buoy" : "");
    text.append("  <").append(kind).append('>').append(name(nameOf(site)));
    text.append(place(site.station())).append(element("psi", site.headingRad()));
    text.append(element("expectedTime", outlook.expectedS()));
    text.append(element("successProbability", outlook.probability()));
    text.append(element("endBy", endByS(site.station())));
    text.append("<objectTypes>").append(types).append("</objectTypes>");
    if (isDock) {
      text.append(way()).append("<next>fetch</next><next if=\"failed\">");
      text.append(names(nameOf(site))).append("</next></dockBoat>\n");
      fetch(site);
    } else {
      text.append(next(nameOf(site))).append("</").append(kind).append(">\n");
    }
  }

  /** The sub-vehicle's task, then undocking; both only once the boat is docked. */
  private void fetch(TaskSite dock) {
    Point at = TaskSite.at(dock.station(), dock.headingRad(), TaskSite.DOCK_WAY_M + 1.0, 0.0);
    text.append("  <fetchGoal>").append(name(FETCH)).append(place(at));
    text.append(element("z", QuadrotorOnDeck.DECK_M + GRIP_M));
    text.append("<horizontalThreshold>0.15</horizontalThreshold>");
    text.append("<verticalThreshold>0.1</verticalThreshold><next>undock</next></fetchGoal>\n");
    text.append("  <dockBoat>").append(name("undock")).append(place(dock.station()));
    text.append(element("psi", dock.headingRad())).append(way());
    text.append("<leaves>true</leaves><timeLimit>60</timeLimit>");
    text.append(next(nameOf(dock))).append("</dockBoat>\n");
  }

  private static String way() {
    return element("way", TaskSite.DOCK_WAY_M);
  }

  private static String nameOf(TaskSite site) {
    return site.task().name().toLowerCase(Locale.ROOT);
  }

  /** All tasks but one, and the return. */
  private String next(String but) {
    return "<next>" + names(but) + "</next>";
  }

  private String names(String but) {
    List<String> names = new ArrayList<>();
    course.sites().stream().map(BoatMission::nameOf).forEach(names::add);
    names.remove(but);
    names.add("return");
    return String.join(", ", names);
  }

  /** Time by which the boat must leave a position to get home [s of the run]. */
  private double endByS(Point from) {
    double metres = 0.0;
    Point at = from;
    for (int i = course.channel().size() - 1; i >= 0; i--) {
      Point middle = course.channel().get(i).middle();
      metres += at.flatDistanceTo(middle);
      at = middle;
    }
    metres += at.flatDistanceTo(course.start());
    return BoatJudge.RUN_S - RESERVE_S - metres / HOMEWARD_MPS;
  }

  private static String name(String name) {
    return "<name>" + name + "</name>";
  }

  private static String element(String name, double value) {
    return String.format(Locale.ROOT, "<%s>%.4f</%s>", name, value, name);
  }

  private String place(Point at) {
    Geodetic place = plane.at(at.y(), at.x(), 0.0);
    return String.format(
        Locale.ROOT, "<x>%.9f</x><y>%.9f</y>", place.longitudeDeg(), place.latitudeDeg());
  }
}
