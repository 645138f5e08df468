package org.u2sa.scenarios.ugv;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** A mission for tests that do not depend on how far the vehicle drives. */
public final class OneWaypoint {
  private static final String MISSION =
      """
      <mission>
        <home><x>-81.0478</x><y>29.1885</y><psi>0</psi></home>
        <waypoint>
          <name>1</name>
          <x>-81.0478</x>
          <y>29.18856</y>
          <horizontalThreshold>0.5</horizontalThreshold>
        </waypoint>
      </mission>
      """;

  private OneWaypoint() {}

  /** Writes a mission to a waypoint 7 m ahead into a folder. */
  public static Path in(Path folder) {
    try {
      return Files.writeString(folder.resolve("one-waypoint.xml"), MISSION);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
