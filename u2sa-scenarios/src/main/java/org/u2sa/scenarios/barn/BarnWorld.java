package org.u2sa.scenarios.barn;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.interfaces.BadInputException;

/**
 * A BARN world as published by its authors, in Gazebo's axes: x to the right, y ahead of the start
 * [m]. Immutable.
 *
 * @param number number N of the file {@code world_N.world}
 * @param pillars centres of the upright cylinders [m]
 * @param pathM length of the shortest path from start to goal, as computed by the challenge [m]
 */
record BarnWorld(int number, List<Place> pillars, double pathM) {
  /** Radius of every cylinder [m]. */
  static final double PILLAR_RADIUS_M = 0.075;

  /** Start position of the challenge's robot, facing along y [m]. */
  static final Place START = new Place(-2.0, 3.0);

  /** Goal position [m]. */
  static final Place GOAL = new Place(-2.0, 13.0);

  private static final Pattern PILLAR =
      Pattern.compile(
          "<model name='unit_cylinder_\\d+'>\\s*<static>1</static>\\s*"
              + "<pose frame=''>(\\S+) (\\S+) ");
  private static final int MAGIC_BYTES = 10; // of NumPy's format 1.0, including the header length
  private static final double CELL_M = 2.0 * PILLAR_RADIUS_M;
  private static final int COLUMNS = 30;
  private static final double FIELD_BEGINS_M = 5.0;

  /** A position [m]. */
  record Place(double x, double y) {
    double distanceM(Place other) {
      return Math.hypot(x - other.x, y - other.y);
    }
  }

  /**
   * Reads {@code world_N.world} and {@code path_files/path_N.npy} of a folder.
   *
   * @throws BadInputException naming the file, if one cannot be read or has another format
   */
  static BarnWorld read(Path folder, int number) {
    Path world = folder.resolve("world_" + number + ".world");
    List<Place> pillars = new ArrayList<>();
    Matcher found = PILLAR.matcher(new String(bytes(world), StandardCharsets.UTF_8));
    while (found.find()) {
      pillars.add(
          new Place(Double.parseDouble(found.group(1)), Double.parseDouble(found.group(2))));
    }
    if (pillars.isEmpty()) {
      throw new BadInputException(world + ": no unit_cylinder; expected a BARN world");
    }
    return new BarnWorld(
        number, List.copyOf(pillars), pathM(folder.resolve("path_files/path_" + number + ".npy")));
  }

  /**
   * Length from the start through all cells of the file to the goal, as in the challenge's run.py.
   */
  private static double pathM(Path file) {
    ByteBuffer npy = ByteBuffer.wrap(bytes(file)).order(ByteOrder.LITTLE_ENDIAN);
    int header = npy.limit() < MAGIC_BYTES ? 0 : npy.getShort(MAGIC_BYTES - 2);
    int cells = (npy.limit() - MAGIC_BYTES - header) / (2 * Long.BYTES);
    if (header <= 0 || cells <= 0) {
      throw new BadInputException(file + ": " + npy.limit() + " bytes; expected NumPy's format");
    }
    npy.position(MAGIC_BYTES + header);
    Place at = START;
    double sum = 0.0;
    for (int i = 0; i < cells; i++) {
      double x = (npy.getLong() - COLUMNS) * CELL_M - PILLAR_RADIUS_M;
      double y = npy.getLong() * CELL_M + PILLAR_RADIUS_M + FIELD_BEGINS_M;
      Place next = new Place(x, y);
      sum += at.distanceM(next);
      at = next;
    }
    return sum + at.distanceM(GOAL);
  }

  private static byte[] bytes(Path file) {
    try {
      return Files.readAllBytes(file);
    } catch (IOException e) {
      throw new BadInputException(file + ": cannot be read: " + e.getMessage(), e);
    }
  }
}
