package org.u2sa.flightgear.demo;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** A mission of take-off and one waypoint straight ahead: two minutes of flight. */
final class ShortMission {
  private static final String TEXT =
      """
      <mission>
        <home>
          <x>-157.943183</x>
          <y>21.325247</y>
          <z unit="ft">17.5</z>
          <psi>90.0</psi>
        </home>
        <waypoint>
          <name>1</name>
          <x>-157.910168</x>
          <y>21.325239</y>
          <z unit="ft">500</z>
          <horizontalThreshold>100</horizontalThreshold>
        </waypoint>
      </mission>
      """;

  private ShortMission() {}

  /** Writes it into a folder. */
  static Path in(Path directory) {
    return in(directory, "", "");
  }

  /** Writes it into a folder with the first occurrence of a text replaced. */
  static Path in(Path directory, String text, String by) {
    if (!TEXT.contains(text)) {
      throw new IllegalArgumentException("the mission has no \"" + text + '"');
    }
    int at = TEXT.indexOf(text);
    try {
      return Files.writeString(
          directory.resolve("short.xml"),
          TEXT.substring(0, at) + by + TEXT.substring(at + text.length()));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
