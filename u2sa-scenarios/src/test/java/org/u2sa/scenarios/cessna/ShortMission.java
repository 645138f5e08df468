package org.u2sa.scenarios.cessna;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Missions from Honolulu's runway that end before the demo's own. */
final class ShortMission {
  private static final String HOME =
      """
      <mission>
        <home>
          <x>-157.943183</x>
          <y>21.325247</y>
          <z unit="ft">17.5</z>
          <psi>90.0</psi>
        </home>
      """;
  private static final String WAYPOINT =
      """
        <waypoint>
          <name>%d</name>
          <x>%s</x>
          <y>%s</y>
          <z unit="ft">%d</z>
          <horizontalThreshold>100</horizontalThreshold>%s
        </waypoint>
      """;
  private static final String END = "</mission>\n";
  private static final String AHEAD = HOME + waypoint(1, "-157.910168", "21.325239", 500, "") + END;

  private ShortMission() {}

  private static String waypoint(
      int name, String longitudeDeg, String latitudeDeg, int altitudeFt, String more) {
    return WAYPOINT.formatted(name, longitudeDeg, latitudeDeg, altitudeFt, more);
  }

  /** Writes take-off and one waypoint straight ahead, two minutes of flight, into a folder. */
  static Path in(Path directory) {
    return in(directory, "", "");
  }

  /** Writes the same with the first occurrence of a text replaced. */
  static Path in(Path directory, String text, String by) {
    if (!AHEAD.contains(text)) {
      throw new IllegalArgumentException("the mission has no \"" + text + '"');
    }
    int at = AHEAD.indexOf(text);
    try {
      return Files.writeString(
          directory.resolve("short.xml"),
          AHEAD.substring(0, at) + by + AHEAD.substring(at + text.length()));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
