package org.u2sa.scenarios.suas;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.mission.Mission;
import org.u2sa.report.ReportFile;

/** Information given to a team: mission, world of the pillars, fence. */
final class SuasMission {
  /** Name of the goal of the drop. */
  static final String DROP = "drop";

  private static final String AREA = "search";

  /** Time to fly home and land [s]: 140 s, plus one approach aborted because of traffic. */
  private static final double LANDING_S = 240.0;

  private static final double TAKE_OFF_M = 60.0;
  private static final double DROP_M = 40.0; // height of the drop
  private static final double KEPT_M = 100.0; // distance of routes from the boundary
  private static final double KEPT_UP_M = 15.0; // distance of evasion from the ceiling
  private static final double KEPT_DOWN_M = 5.0; // and from the floor

  private final SuasField field;

  private SuasMission(SuasField field) {
    this.field = field;
  }

  static Mission write(SuasField field, Path file) {
    String text = new SuasMission(field).mission();
    ReportFile.writeText(file, out -> out.write(text));
    return Mission.load(file);
  }

  /** Writes the fence of a field. */
  static Path fence(SuasField field, Path file) {
    StringBuilder text = new StringBuilder("<fence>\n");
    text.append(
        String.format(
            Locale.ROOT,
            "  <ceiling unit=\"m\">%.1f</ceiling>%n  <keepIn>%n",
            SuasField.ORIGIN.altitudeM() + field.ceilingM()));
    for (Point corner : field.boundary()) {
      text.append("    <corner>").append(place(corner)).append("</corner>\n");
    }
    text.append("  </keepIn>\n</fence>\n");
    ReportFile.writeText(file, out -> out.write(text.toString()));
    return file;
  }

  /** Writes the pillars and the permitted area of routes as a world file. */
  static Path world(SuasField field, Path file) {
    StringBuilder text = new StringBuilder("<world>\n");
    for (int i = 0; i < field.pillars().size(); i++) {
      SuasField.Pillar pillar = field.pillars().get(i);
      text.append("  <cylinder><uid>pillar ").append(i + 1).append("</uid>");
      text.append("<referenceFrame>Global</referenceFrame>");
      text.append(place(Point.of(pillar.eastM(), pillar.northM(), 0.0)));
      text.append(
          String.format(
              Locale.ROOT,
              "<z>%.2f</z><radius>%.2f</radius><height>%.2f</height></cylinder>%n",
              SuasField.ORIGIN.altitudeM() + 0.5 * pillar.heightM(),
              pillar.radiusM(),
              pillar.heightM()));
    }
    text.append("  <polygon><uid>boundary</uid><objectType>corridor</objectType>");
    text.append("<referenceFrame>Global</referenceFrame><points>");
    List<Point> inside =
        field.boundary().stream()
            .map(corner -> corner.times(1.0 - KEPT_M / corner.distance()))
            .collect(Collectors.toList());
    text.append(corners(inside)).append("</points>");
    double top = field.ceilingM() - KEPT_UP_M;
    double bottom = field.floorM() + KEPT_DOWN_M;
    text.append(altitude(0.5 * (top + bottom)));
    text.append(String.format(Locale.ROOT, "<height>%.2f</height>", top - bottom));
    text.append("</polygon>\n</world>\n");
    ReportFile.writeText(file, out -> out.write(text.toString()));
    return file;
  }

  private String mission() {
    StringBuilder text =
        new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<mission>\n");
    text.append(
        String.format(
            Locale.ROOT,
            "  <timeLimit next=\"landing\">%.0f</timeLimit>%n",
            SuasJudge.RUN_S - LANDING_S));
    text.append("  <home>").append(place(field.start())).append(altitude(0.0));
    text.append(
        String.format(Locale.ROOT, "<psi>%.4f</psi></home>%n", Math.toDegrees(field.runwayRad())));
    text.append("  <takeOff><name>take-off</name>").append(place(field.start().times(-1.0)));
    text.append(altitude(TAKE_OFF_M));
    text.append("<horizontalThreshold>60</horizontalThreshold></takeOff>\n");
    for (int i = 0; i < field.waypoints().size(); i++) {
      Point waypoint = field.waypoints().get(i);
      text.append("  <waypoint><name>").append(i + 1).append("</name>").append(place(waypoint));
      text.append(altitude(waypoint.z()));
      text.append("<horizontalThreshold>12</horizontalThreshold>");
      text.append("<verticalThreshold>8</verticalThreshold></waypoint>\n");
    }
    text.append("  <payloadDrop><name>" + DROP + "</name>")
        .append(place(field.drop()))
        .append(altitude(0.0));
    text.append(
        String.format(
            Locale.ROOT,
            "<height>%.0f</height><terminalSpeed>%.0f</terminalSpeed>"
                + "<horizontalThreshold>8</horizontalThreshold></payloadDrop>%n",
            DROP_M,
            DroppedBottle.TERMINAL_MPS));
    Point touch = field.start().times(0.8);
    text.append("  <landing><name>landing</name>").append(place(touch)).append(altitude(0.0));
    text.append(
        String.format(
            Locale.ROOT,
            "<psi>%.5f</psi><horizontalThreshold>60</horizontalThreshold>"
                + "<speed>18</speed><approach>500</approach><slope unit=\"deg\">5.5</slope></landing>%n",
            field.runwayRad()));
    return text.append("</mission>\n").toString();
  }

  private static String altitude(double upM) {
    return String.format(Locale.ROOT, "<z>%.2f</z>", SuasField.ORIGIN.altitudeM() + upM);
  }

  /** The search area as sent by the ground station in flight. */
  static String area(SuasField field) {
    return String.format(
        Locale.ROOT,
        "<mission><searchArea><name>%s</name><corners>%s</corners><resolution>%.3f</resolution>"
            + "<ground>%.2f</ground><share>0.997</share></searchArea></mission>",
        AREA,
        corners(field.searchArea()),
        field.resolutionM(),
        SuasField.ORIGIN.altitudeM());
  }

  private static String corners(List<Point> places) {
    return places.stream()
        .map(corner -> SuasField.plane().at(corner.x(), corner.y(), 0.0))
        .map(at -> String.format(Locale.ROOT, "%.8f %.8f", at.longitudeDeg(), at.latitudeDeg()))
        .collect(Collectors.joining("; "));
  }

  private static String place(Point at) {
    Geodetic place = SuasField.plane().at(at.x(), at.y(), 0.0);
    return String.format(
        Locale.ROOT, "<x>%.8f</x><y>%.8f</y>", place.longitudeDeg(), place.latitudeDeg());
  }
}
