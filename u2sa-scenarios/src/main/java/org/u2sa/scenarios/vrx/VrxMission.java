package org.u2sa.scenarios.vrx;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.mission.Mission;
import org.u2sa.report.ReportFile;

/** Writes the mission for a world's task. */
final class VrxMission {
  private static final double WITHIN_M = 0.15; // radius in which the best error counts
  private static final double START_WITHIN_M = 1.0;
  private static final double STAY_S = 4.0;
  private static final double CIRCLE_SHARE = 0.55; // fraction of the engagement distance
  private static final double CLEARANCE_M = 3.0; // extra distance from animals to be avoided
  private static final String GATES =
      "  <gateCourse><name>gates</name>"
          + "<objectTypes>white marker, green marker, black marker, red marker</objectTypes></gateCourse>\n";

  private VrxMission() {}

  static Mission write(VrxWorld world, Path file) {
    StringBuilder text = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    text.append("<!-- ").append(world.file().getFileName()).append(" of VRX. -->\n<mission>\n");
    text.append("  <home>").append(place(world, VrxWorld.START));
    text.append(degrees("<psi>", VrxWorld.START_HEADING_RAD)).append("</home>\n");
    switch (world.task()) {
      case STATIONKEEPING -> text.append(station("station", world.goals().get(0), WITHIN_M, 0.0));
      case WAYFINDING -> {
        double stayS = STAY_S + world.times().readyS(); // at the first gate, which may be close
        for (int i : order(world)) {
          text.append(station("waypoint " + (i + 1), world.goals().get(i), WITHIN_M, stayS));
          stayS = STAY_S;
        }
      }
      case PATH -> text.append(start(world)).append(GATES);
      case WILDLIFE -> text.append(start(world)).append(animals(world.wildlife()));
      case DOCK -> text.append(start(world)).append(berth(world.docking()));
    }
    ReportFile.writeText(file, out -> out.write(text.append("</mission>\n").toString()));
    return Mission.load(file);
  }

  /**
   * @param stayS how long to stay [s]; 0: to the end
   */
  private static String station(String name, VrxWorld.Goal goal, double withinM, double stayS) {
    String where =
        String.format(
            Locale.ROOT, "<x>%.9f</x><y>%.9f</y>", goal.longitudeDeg(), goal.latitudeDeg());
    return "  <Station><name>"
        + name
        + "</name>"
        + where
        + degrees("<psi unit=\"deg\">", goal.headingRad())
        + "<horizontalThreshold>"
        + withinM
        + "</horizontalThreshold>"
        + (stayS > 0.0 ? "<duration>" + stayS + "</duration>" : "")
        + "</Station>\n";
  }

  /**
   * Waits at the start until the running state begins, because nothing counts before. VRX publishes
   * the state of the task; here the wait replaces it.
   */
  private static String start(VrxWorld world) {
    Geodetic start = world.plane().at(VrxWorld.START.x(), VrxWorld.START.y(), 0.0);
    VrxWorld.Goal here =
        new VrxWorld.Goal(start.longitudeDeg(), start.latitudeDeg(), VrxWorld.START_HEADING_RAD);
    return station("start", here, START_WITHIN_M, world.times().readyS());
  }

  /** Species and their treatment are the same in all worlds; positions are announced. */
  private static String animals(Wildlife wildlife) {
    return String.format(
        Locale.ROOT,
        "  <circleObjects><name>animals</name><clockwise>%s</clockwise><anticlockwise>%s</anticlockwise>"
            + "<avoided>%s</avoided><radius>%.1f</radius><within>%.1f</within><clearance>%.1f</clearance></circleObjects>%n",
        Wildlife.Part.CLOCKWISE.species(),
        Wildlife.Part.ANTICLOCKWISE.species(),
        Wildlife.Part.AVOID.species(),
        CIRCLE_SHARE * wildlife.engagementM(),
        wildlife.engagementM(),
        wildlife.engagementM() + CLEARANCE_M);
  }

  private static String berth(Docking docking) {
    return String.format(
        Locale.ROOT,
        "  <dockBySign><name>dock</name><duration>%.1f</duration></dockBySign>%n",
        docking.stayS() + 1.0);
  }

  /** Shortest order of the goals from the start, by trying all: VRX has up to five. */
  private static List<Integer> order(VrxWorld world) {
    List<Point> places = new ArrayList<>();
    for (VrxWorld.Goal goal : world.goals()) {
      places.add(world.plane().point(new Geodetic(goal.longitudeDeg(), goal.latitudeDeg(), 0.0)));
    }
    List<Integer> best = new ArrayList<>();
    search(places, new ArrayList<>(), 0.0, new double[] {Double.POSITIVE_INFINITY}, best);
    return best;
  }

  private static void search(
      List<Point> places, List<Integer> sofar, double lengthM, double[] least, List<Integer> best) {
    if (lengthM >= least[0]) {
      return;
    }
    if (sofar.size() == places.size()) {
      least[0] = lengthM;
      best.clear();
      best.addAll(sofar);
      return;
    }
    Point from = sofar.isEmpty() ? VrxWorld.START : places.get(sofar.get(sofar.size() - 1));
    for (int i = 0; i < places.size(); i++) {
      if (!sofar.contains(i)) {
        sofar.add(i);
        double leg = places.get(i).minus(from).distance();
        search(places, sofar, lengthM + leg, least, best);
        sofar.remove(sofar.size() - 1);
      }
    }
  }

  private static String place(VrxWorld world, Point at) {
    Geodetic place = world.plane().at(at.x(), at.y(), 0.0);
    return String.format(
        Locale.ROOT, "<x>%.9f</x><y>%.9f</y>", place.longitudeDeg(), place.latitudeDeg());
  }

  private static String degrees(String tag, double angleRad) {
    return String.format(Locale.ROOT, "%s%.6f</psi>", tag, Math.toDegrees(angleRad));
  }
}
