package org.u2sa.interfaces.terrain;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.StringTokenizer;
import java.util.TreeMap;
import java.util.function.Function;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/**
 * Altitudes of the ground on a grid of longitudes and latitudes (WGS 84), read from an Esri ASCII
 * grid, as gdal_translate -of AAIGrid writes it. Immutable.
 */
public final class HeightGrid {
  private static final int MAX_CELLS = 4_000_000;
  private static final int MAX_LINE = 1_000_000; // characters
  private static final long MAX_BYTES = 100_000_000L; // maximum per line
  private static final double FULL_TURN_DEG = 360.0;
  private static final Set<String> KEYS =
      Set.of(
          "ncols",
          "nrows",
          "xllcorner",
          "yllcorner",
          "xllcenter",
          "yllcenter",
          "cellsize",
          "nodata_value");

  private final int columns;
  private final int rows;
  private final double westDeg; // middle of the first column
  private final double southDeg; // middle of the last row
  private final double cellDeg;
  private final float[] altitudes; // rows from the north [m]; NaN: unknown

  private HeightGrid(Map<String, Double> head, String file) {
    columns = count(head, "ncols", file);
    rows = count(head, "nrows", file);
    if ((long) columns * rows > MAX_CELLS) {
      throw new BadInputException(
          file + ": " + columns + " by " + rows + " heights; expected at most " + MAX_CELLS);
    }
    cellDeg = value(head, "cellsize", file);
    if (!(cellDeg > 0.0 && cellDeg <= 1.0)) {
      throw new BadInputException(
          file + ": cellsize " + cellDeg + "; expected degrees, above 0 and at most 1");
    }
    westDeg = edge(head, "x", file);
    southDeg = edge(head, "y", file);
    if (!(Math.abs(southDeg) <= 90.0 && Math.abs(westDeg) <= 360.0)) {
      throw new BadInputException(
          file + ": corner " + westDeg + ", " + southDeg + "; expected longitude and latitude");
    }
    altitudes = new float[columns * rows];
  }

  private double edge(Map<String, Double> head, String axis, String file) {
    Double middle = head.get(axis + "llcenter");
    return middle == null ? value(head, axis + "llcorner", file) + 0.5 * cellDeg : middle;
  }

  private static double value(Map<String, Double> head, String key, String file) {
    Double value = head.get(key);
    if (value == null) {
      throw new BadInputException(file + ": has no " + key + "; expected an Esri ASCII grid");
    }
    return value;
  }

  private static int count(Map<String, Double> head, String key, String file) {
    double value = value(head, key, file);
    if (value != Math.rint(value) || value < 2.0 || value > MAX_CELLS) {
      throw new BadInputException(
          file + ": " + key + " " + value + "; expected a number of cells, at least 2");
    }
    return (int) value;
  }

  /**
   * Reads the grid that a configuration names.
   *
   * @param file its variable; empty for none
   * @param resolve finds the file
   */
  public static Optional<HeightGrid> named(String file, Function<String, Path> resolve) {
    return file.isEmpty() ? Optional.empty() : Optional.of(read(resolve.apply(file)));
  }

  /**
   * Reads a grid.
   *
   * @throws BadInputException naming the file, if it is invalid
   */
  public static HeightGrid read(Path file) {
    if (!Files.isRegularFile(file)) {
      throw new BadInputException(file + ": height map: no such regular file");
    }
    try (BufferedReader in = Files.newBufferedReader(file, StandardCharsets.US_ASCII)) {
      if (Files.size(file) > MAX_BYTES) {
        throw new IOException("more than " + MAX_BYTES + " bytes");
      }
      return read(in, file.toString());
    } catch (IOException e) {
      throw new BadInputException(file + ": height map: " + e.getMessage(), e);
    }
  }

  private static HeightGrid read(BufferedReader in, String file) throws IOException {
    Map<String, Double> head = new TreeMap<>();
    HeightGrid grid = null;
    int count = 0;
    for (String line = in.readLine(); line != null; line = in.readLine()) {
      if (line.length() > MAX_LINE) {
        throw new IOException("a line of " + line.length() + " characters");
      }
      StringTokenizer words = new StringTokenizer(line);
      if (grid == null && words.countTokens() == 2) {
        String key = words.nextToken().toLowerCase(Locale.ROOT);
        if (KEYS.contains(key)) {
          head.put(key, number(words.nextToken(), file));
          continue;
        }
        words = new StringTokenizer(line);
      }
      if (!words.hasMoreTokens()) {
        continue;
      }
      grid = grid == null ? new HeightGrid(head, file) : grid;
      while (words.hasMoreTokens()) {
        double height = number(words.nextToken(), file);
        if (count == grid.altitudes.length) {
          throw new IOException("more heights than " + grid.columns + " by " + grid.rows);
        }
        boolean isKnown = height != head.getOrDefault("nodata_value", -9999.0);
        grid.altitudes[count++] = isKnown ? (float) height : Float.NaN;
      }
    }
    if (grid == null || count < grid.altitudes.length) {
      throw new IOException(count + " heights; expected as many as ncols by nrows");
    }
    return grid;
  }

  private static double number(String text, String file) {
    try {
      double value = Double.parseDouble(text);
      if (Math.abs(value) <= 1e9) {
        return value;
      }
    } catch (NumberFormatException e) {
      throw new BadInputException(file + ": \"" + text + "\"; expected a number", e);
    }
    throw new BadInputException(file + ": \"" + text + "\"; expected a number within ±1e9");
  }

  /** Altitude of the ground at a place [m], bilinear; empty outside the grid or where unknown. */
  public OptionalDouble altitudeM(Geodetic place) {
    double eastDeg = (place.longitudeDeg() - westDeg) % FULL_TURN_DEG; // maps may exceed 180°
    double x = (eastDeg < 0.0 ? eastDeg + FULL_TURN_DEG : eastDeg) / cellDeg;
    double y = rows - 1.0 - (place.latitudeDeg() - southDeg) / cellDeg;
    if (!(x >= 0.0 && y >= 0.0 && x <= columns - 1.0 && y <= rows - 1.0)) {
      return OptionalDouble.empty();
    }
    int left = Math.min(columns - 2, (int) x);
    int top = Math.min(rows - 2, (int) y);
    double right = x - left;
    double down = y - top;
    int at = top * columns + left;
    double altitude =
        (1.0 - down) * ((1.0 - right) * altitudes[at] + right * altitudes[at + 1])
            + down
                * ((1.0 - right) * altitudes[at + columns] + right * altitudes[at + columns + 1]);
    return Double.isNaN(altitude) ? OptionalDouble.empty() : OptionalDouble.of(altitude);
  }

  /** Distance from a place to the grid [m]; 0 on it, also where no height is known. */
  public double outsideM(Geodetic place) {
    double full = FULL_TURN_DEG / cellDeg;
    double eastDeg = (place.longitudeDeg() - westDeg) % FULL_TURN_DEG;
    double x = (eastDeg < 0.0 ? eastDeg + FULL_TURN_DEG : eastDeg) / cellDeg;
    double east = x - (columns - 1.0);
    double west = full - x;
    double aside = east <= 0.0 ? 0.0 : east < west ? -east : west;
    double y = rows - 1.0 - (place.latitudeDeg() - southDeg) / cellDeg;
    double up = Math.max(0.0, Math.min(rows - 1.0, y)) - y;
    Geodetic edge =
        new Geodetic(
            place.longitudeDeg() + aside * cellDeg,
            place.latitudeDeg() - up * cellDeg,
            place.altitudeM());
    Point ned = place.nedOf(edge);
    return Math.hypot(ned.x(), ned.y());
  }
}
