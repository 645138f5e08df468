package org.u2sa.vision.survey;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.SearchArea;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;

/**
 * Orders closer looks at unreadable targets: small search areas of finer resolution, which the
 * Mission Manager inserts before the current goal (thesis 4.4.1.1).
 *
 * @param resolution resolution of these areas, as a share of the previous area's
 */
record CloserLook(double resolution) {
  private static final double HALF_M = 8.0; // half a side; targets are located to a few metres
  private static final double SHARE = 0.9;

  /**
   * @param area search area in which the targets were seen
   * @param camera name of the camera, the author of the order
   * @param first number of the first of these goals, used in its name
   * @param micros time, which makes the order unique [µs]
   */
  MissionOrder order(
      SearchArea area, List<Geodetic> places, String camera, int first, long micros) {
    StringBuilder goals = new StringBuilder("<mission>");
    for (int i = 0; i < places.size(); i++) {
      goals.append(goal(area, places.get(i), camera + " look " + (first + i)));
    }
    return new MissionOrder()
        .requestId(camera + " look " + micros)
        .action(MissionAction.INSERT)
        .goals(goals.append("</mission>").toString())
        .now(true)
        .operator(camera);
  }

  private String goal(SearchArea area, Geodetic middle, String name) {
    StringBuilder goal = new StringBuilder("<searchArea>");
    element(goal, "name", name);
    element(goal, "corners", corners(middle));
    number(
        goal, "resolution", Math.max(SearchArea.MIN_RESOLUTION_M, resolution * area.resolution()));
    number(goal, "ground", area.ground());
    area.lowest().ifPresent(metres -> number(goal, "lowest", metres));
    area.highest().ifPresent(metres -> number(goal, "highest", metres));
    area.speed().ifPresent(metresPerSecond -> number(goal, "speed", metresPerSecond));
    number(goal, "share", SHARE);
    return goal.append("</searchArea>").toString();
  }

  private static String corners(Geodetic middle) {
    return List.of(
            Point.of(-HALF_M, -HALF_M, 0.0),
            Point.of(HALF_M, -HALF_M, 0.0),
            Point.of(HALF_M, HALF_M, 0.0),
            Point.of(-HALF_M, HALF_M, 0.0))
        .stream()
        .map(middle::fromEnu)
        .map(at -> String.format(Locale.ROOT, "%.8f %.8f", at.longitudeDeg(), at.latitudeDeg()))
        .collect(Collectors.joining("; "));
  }

  private static void number(StringBuilder goal, String name, double value) {
    element(goal, name, String.format(Locale.ROOT, "%.4f", value));
  }

  private static void element(StringBuilder goal, String name, String text) {
    String escaped = text.replace("&", "&amp;").replace("<", "&lt;");
    goal.append('<').append(name).append('>').append(escaped);
    goal.append("</").append(name).append('>');
  }
}
