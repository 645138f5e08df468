package org.u2sa.scenarios.barn;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/**
 * Converts a BARN world to U2SA's world and mission files, scaled to a vehicle's width.
 *
 * @param scale metres here per metre of the challenge
 */
record BarnCourse(BarnWorld world, double scale) {
  /** Width of the challenge's robot, Clearpath's Jackal [m]. */
  static final double JACKAL_WIDTH_M = 0.43;

  private static final Geodetic HOME = new Geodetic(-81.0478, 29.1885, 0.0);
  private static final double HEIGHT_M = 1.0;
  private static final double REACHED_M = 1.0; // in the challenge

  /** Goal radius [m]. */
  double reachedM() {
    return REACHED_M * scale;
  }

  /** Length of the shortest path [m]. */
  double pathM() {
    return world.pathM() * scale;
  }

  /** Goal position. */
  Geodetic goal() {
    return at(BarnWorld.GOAL);
  }

  /** Start position. */
  Geodetic start() {
    return HOME;
  }

  private Geodetic at(BarnWorld.Place place) {
    return HOME.fromEnu(
        Point.of(
            scale * (place.x() - BarnWorld.START.x()),
            scale * (place.y() - BarnWorld.START.y()),
            0.0));
  }

  void writeWorld(Path file) throws IOException {
    StringBuilder text = new StringBuilder("<world>\n");
    int number = 0;
    for (BarnWorld.Place pillar : world.pillars()) {
      Geodetic at = at(pillar);
      text.append(
          String.format(
              Locale.ROOT,
              "  <Cylinder><uid>pillar %d</uid><type>pillar</type><x>%.9f</x><y>%.9f</y>"
                  + "<z>%.1f</z><radius>%.4f</radius><height>%.1f</height></Cylinder>%n",
              ++number,
              at.longitudeDeg(),
              at.latitudeDeg(),
              0.5 * HEIGHT_M,
              scale * BarnWorld.PILLAR_RADIUS_M,
              HEIGHT_M));
    }
    Files.writeString(file, text.append("</world>\n"));
  }

  /** Writes the mission file: the one goal, with the challenge's threshold. */
  void writeMission(Path file) throws IOException {
    Files.writeString(
        file,
        String.format(
            Locale.ROOT,
            "<mission>%n  <home><x>%.9f</x><y>%.9f</y><psi>0</psi></home>%n"
                + "  <waypoint><name>goal</name><x>%.9f</x><y>%.9f</y>"
                + "<horizontalThreshold>%.3f</horizontalThreshold></waypoint>%n</mission>%n",
            HOME.longitudeDeg(),
            HOME.latitudeDeg(),
            goal().longitudeDeg(),
            goal().latitudeDeg(),
            reachedM()));
  }
}
