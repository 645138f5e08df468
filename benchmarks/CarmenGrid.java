package org.u2sa.world.grid;

import java.awt.image.BufferedImage;
import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.zip.GZIPInputStream;
import javax.imageio.ImageIO;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.world.modeller.MapFrame;
import org.u2sa.world.modeller.ScanPoses;
import org.u2sa.world.modeller.SensorPose;
import org.u2sa.world.modeller.Sighting;

/**
 * Enters a published CARMEN lidar log with its corrected poses into the World Modeler's grid and
 * prints how well the grid explains the scans that it was made of: {@code java -Ddeg=2
 * … CarmenGrid intel-corrected.log.gz}. System properties: {@code deg}, angle between the beams used
 * [deg], 1 if absent; {@code cell}, side of a cell [m], 0.05; {@code png}, a file to draw the grid
 * into. The window covers the whole recording and does not roll.
 */
final class CarmenGrid {
  private static final double REACH = 40.0; // larger values are the scanner's "nothing"
  private static final int STANDING_SCANS = 20; // between two echoes of a thing that stands

  private record Shot(int number, StateInformation vehicle, RangeScan scan) {}

  /** The grid's window, with what a message of it would say. */
  private record Grid(GridWindow window) {
    byte at(Point point) {
      double column = window.column(point.x());
      double row = window.row(point.y());
      boolean inside =
          column >= 0.0 && row >= 0.0 && column < window.side() && row < window.side();
      return inside
          ? window.cells()[(int) row * window.side() + (int) column]
          : OccupancyGrid.UNKNOWN;
    }
  }

  public static void main(String[] arguments) throws IOException {
    double cell = Double.parseDouble(System.getProperty("cell", "0.05"));
    List<Shot> shots = read(Path.of(arguments[0]));
    GridWindow window = window(shots, cell);
    ScanEntry entry = new ScanEntry(window, new LogOdds(0.85, 0.4, -2.0, 3.5));
    ScanEntry.Band band = new ScanEntry.Band(-0.1, 2.0, 0.0);
    MapFrame frame = MapFrame.of(shots.get(0).vehicle());
    long beams = 0;
    long began = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
    for (Shot shot : shots) {
      Sighting sighting = new Sighting(0L, frame, Optional.of(shot.vehicle()));
      beams += entry.enter(shot.scan(), ScanPoses.still(sighting), band, 1.0);
    }
    double seconds =
        (ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - began) / 1e9;
    System.out.printf(
        "%s: %d scans, %d beams, %.2f s of one core (cold start included), %d x %d cells of %.2f m%n",
        arguments[0], shots.size(), beams, seconds, window.side(), window.side(), cell);
    score(new Grid(window), shots);
    if (System.getProperty("png") != null) {
      draw(window, new File(System.getProperty("png")));
    }
  }

  private static List<Shot> read(Path log) throws IOException {
    List<Shot> shots = new ArrayList<>();
    try (BufferedReader in =
        new BufferedReader(
            new InputStreamReader(
                new GZIPInputStream(Files.newInputStream(log)), StandardCharsets.US_ASCII))) {
      for (String line = in.readLine(); line != null; line = in.readLine()) {
        if (line.startsWith("FLASER ")) {
          shots.add(shot(shots.size(), line.trim().split("\\s+")));
        }
      }
    }
    if (shots.isEmpty()) {
      throw new IOException(log + ": no FLASER line; expected a CARMEN log");
    }
    return shots;
  }

  /**
   * FLASER count ranges… x y theta odom_x odom_y odom_theta time host time. The beams cover 180°: an
   * odd number of them both ends, an even number all but the last.
   */
  private static Shot shot(int number, String[] part) {
    int beams = Integer.parseInt(part[1]);
    double stepDeg = 180.0 / (beams % 2 == 1 ? beams - 1 : beams);
    double usedDeg = Double.parseDouble(System.getProperty("deg", "1"));
    int every = Math.max(1, (int) Math.round(usedDeg / stepDeg));
    List<OptionalDouble> ranges = new ArrayList<>();
    for (int i = 0; i < beams; i += every) {
      double range = Double.parseDouble(part[2 + i]);
      ranges.add(range < REACH ? OptionalDouble.of(range) : OptionalDouble.empty());
    }
    int pose = 2 + beams;
    StateInformation vehicle =
        new StateInformation()
            .referenceFrame(ReferenceFrame.LOCAL_ENU)
            .x(Double.parseDouble(part[pose]))
            .y(Double.parseDouble(part[pose + 1]))
            .psi(Double.parseDouble(part[pose + 2]));
    RangeScan scan =
        new RangeScan()
            .sensorName("FLASER")
            .maxRange(REACH)
            .beams(-Math.PI / 2.0, Math.toRadians(every * stepDeg), ranges); // right to left
    return new Shot(number, vehicle, scan);
  }

  /** A window that holds all places from which scans were taken, and what they reached. */
  private static GridWindow window(List<Shot> shots, double cell) {
    double[] x = shots.stream().mapToDouble(shot -> shot.vehicle().x().orElseThrow()).toArray();
    double[] y = shots.stream().mapToDouble(shot -> shot.vehicle().y().orElseThrow()).toArray();
    DoubleSummaryStatistics wide = Arrays.stream(x).summaryStatistics();
    DoubleSummaryStatistics high = Arrays.stream(y).summaryStatistics();
    double side =
        Math.max(wide.getMax() - wide.getMin(), high.getMax() - high.getMin()) + 2.0 * REACH;
    GridWindow window = new GridWindow(cell, (int) Math.ceil(side / cell));
    window.move(
        Math.round((wide.getMin() - REACH) / cell), Math.round((high.getMin() - REACH) / cell));
    return window;
  }

  /**
   * How many echoes lie on or beside an occupied cell; how many of those do so of which another scan
   * saw an echo beside them at least {@link #STANDING_SCANS} scans earlier or later, as people who walk
   * about are not to stay on the grid; and how many beams cross an occupied cell.
   */
  private static void score(Grid grid, List<Shot> shots) {
    double cell = grid.window().resolution();
    Map<Long, int[]> spans = new HashMap<>(); // first and last scan with an echo in each cell
    forEachEcho(
        shots,
        (shot, pose, beam) -> {
          Point end = pose.at(beam.angle(), beam.range().getAsDouble());
          int[] span =
              spans.computeIfAbsent(
                  key(end, cell, 0, 0), key -> new int[] {shot.number(), shot.number()});
          span[0] = Math.min(span[0], shot.number());
          span[1] = Math.max(span[1], shot.number());
        });
    long[] counts = new long[5]; // echoes, kept, standing, standing and kept, beams that cross
    forEachEcho(
        shots,
        (shot, pose, beam) -> {
          double range = beam.range().getAsDouble();
          Point end = pose.at(beam.angle(), range);
          boolean kept = false;
          boolean standing = false;
          for (int i = -1; i <= 1; i++) {
            for (int k = -1; k <= 1; k++) {
              kept |= grid.at(Point.of(end.x() + i * cell, end.y() + k * cell, 0.0)) > 0;
              int[] span = spans.get(key(end, cell, i, k));
              standing |=
                  span != null
                      && (span[0] <= shot.number() - STANDING_SCANS
                          || span[1] >= shot.number() + STANDING_SCANS);
            }
          }
          boolean blocked = false;
          for (double r = 0.3; r < range - 0.3; r += cell) {
            blocked |= grid.at(pose.at(beam.angle(), r)) > 0;
          }
          counts[0]++;
          counts[1] += kept ? 1 : 0;
          counts[2] += standing ? 1 : 0;
          counts[3] += standing && kept ? 1 : 0;
          counts[4] += blocked ? 1 : 0;
        });
    System.out.printf(
        "%.2f %% of %d echoes on or beside an occupied cell; %.2f %% of the %d seen again %d scans "
            + "apart; %.2f %% of beams cross one before their end%n",
        100.0 * counts[1] / counts[0],
        counts[0],
        100.0 * counts[3] / counts[2],
        counts[2],
        STANDING_SCANS,
        100.0 * counts[4] / counts[0]);
  }

  @FunctionalInterface
  private interface Echo {
    void take(Shot shot, SensorPose pose, RangeScan.Beam beam);
  }

  private static void forEachEcho(List<Shot> shots, Echo echo) {
    for (Shot shot : shots) {
      SensorPose pose =
          SensorPose.of(shot.scan(), MapFrame.of(shot.vehicle()), Optional.of(shot.vehicle()));
      for (RangeScan.Beam beam : shot.scan().beams()) {
        if (beam.range().isPresent()) {
          echo.take(shot, pose, beam);
        }
      }
    }
  }

  private static long key(Point point, double cell, int asideX, int asideY) {
    long column = (long) Math.floor(point.x() / cell) + asideX;
    long row = (long) Math.floor(point.y() / cell) + asideY;
    return column << 32 | row & 0xFFFFFFFFL;
  }

  private static void draw(GridWindow grid, File file) throws IOException {
    byte[] cells = grid.cells();
    int columns = grid.side();
    int left = columns;
    int right = 0;
    int bottom = columns;
    int top = 0;
    for (int i = 0; i < cells.length; i++) {
      if (cells[i] != OccupancyGrid.UNKNOWN) {
        left = Math.min(left, i % columns);
        right = Math.max(right, i % columns);
        bottom = Math.min(bottom, i / columns);
        top = Math.max(top, i / columns);
      }
    }
    BufferedImage image =
        new BufferedImage(right - left + 1, top - bottom + 1, BufferedImage.TYPE_INT_RGB);
    for (int row = bottom; row <= top; row++) {
      for (int column = left; column <= right; column++) {
        double occupied = OccupancyGrid.probability(cells[row * columns + column]);
        int grey = (int) Math.round(255.0 * (1.0 - occupied));
        image.setRGB(column - left, top - row, grey << 16 | grey << 8 | grey);
      }
    }
    ImageIO.write(image, "png", file);
  }
}
