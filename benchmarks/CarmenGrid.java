package org.u2sa.core.world;

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
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.zip.GZIPInputStream;
import javax.imageio.ImageIO;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * Enters a published CARMEN lidar log with its corrected poses into the World Modeler's grid, prints
 * how well the map explains the scans that it was made of, and draws it: {@code CarmenGrid
 * intel-corrected.log.gz out.png [cell size in m]}.
 */
final class CarmenGrid {
  private static final double REACH = 40.0; // larger values are the scanner's "nothing"
  private static final double HALF_TURN = Math.PI;

  private record Shot(StateInformation vehicle, RangeScan scan) {}

  public static void main(String[] arguments) throws IOException {
    double cell = arguments.length > 2 ? Double.parseDouble(arguments[2]) : 0.05;
    List<Shot> shots = read(Path.of(arguments[0]));
    double[] box = box(shots);
    double side = Math.max(box[2] - box[0], box[3] - box[1]) + 2.0 * 15.0;
    GridModeller modeller =
        new GridModeller(
            XmlConfiguration.inMemory(
                "benchmark",
                Map.of("CELL SIZE", cell, "GRID SIZE", 2.0 * side, "FREE WITHOUT ECHO", 0.0)));
    StateInformation first = shots.get(0).vehicle();
    MapFrame frame = MapFrame.of(first);
    Sighting start = new Sighting(0L, frame, Optional.of(first));
    modeller.enter(frame, start);
    long began = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
    for (Shot shot : shots) {
      Sighting sighting =
          new Sighting(shot.scan().timestamp().orElseThrow(), frame, Optional.of(shot.vehicle()));
      modeller.scan(shot.scan(), ScanPoses.still(sighting));
    }
    double seconds =
        (ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - began) / 1e9;
    OccupancyGrid grid = modeller.grid(start).orElseThrow();
    System.out.printf(
        "%s: %d scans, %d beams, %.2f s of one core (%.1f M beams/s, cold start included)%n",
        arguments[0], shots.size(), 180 * shots.size(), seconds, 180e-6 * shots.size() / seconds);
    score(grid, shots);
    System.out.printf(
        "message: %d x %d cells of %.2f m in %d bytes%n",
        grid.columns(), grid.rows(), cell, grid.serialize().length);
    draw(grid, new File(arguments[1]));
  }

  private static List<Shot> read(Path log) throws IOException {
    List<Shot> shots = new ArrayList<>();
    try (BufferedReader in =
        new BufferedReader(
            new InputStreamReader(
                new GZIPInputStream(Files.newInputStream(log)), StandardCharsets.US_ASCII))) {
      for (String line = in.readLine(); line != null; line = in.readLine()) {
        if (line.startsWith("FLASER ")) {
          shots.add(shot(line.trim().split("\\s+")));
        }
      }
    }
    return shots;
  }

  /** FLASER count ranges… x y theta odom_x odom_y odom_theta time host time. */
  private static Shot shot(String[] part) {
    int beams = Integer.parseInt(part[1]);
    List<OptionalDouble> ranges = new ArrayList<>();
    for (int i = 0; i < beams; i++) {
      double range = Double.parseDouble(part[2 + i]);
      ranges.add(range < REACH ? OptionalDouble.of(range) : OptionalDouble.empty());
    }
    StateInformation vehicle =
        new StateInformation()
            .referenceFrame(ReferenceFrame.LOCAL_ENU)
            .x(Double.parseDouble(part[2 + beams]))
            .y(Double.parseDouble(part[3 + beams]))
            .psi(Double.parseDouble(part[4 + beams]));
    RangeScan scan =
        new RangeScan()
            .sensorName("FLASER")
            .maxRange(REACH)
            .beams(-HALF_TURN / 2.0, HALF_TURN / beams, ranges); // from the right to the left
    scan.timestamp(Math.round(1e6 * Double.parseDouble(part[8 + beams])));
    return new Shot(vehicle, scan);
  }

  private static double[] box(List<Shot> shots) {
    double[] box = {1e9, 1e9, -1e9, -1e9};
    for (Shot shot : shots) {
      double x = shot.vehicle().x().orElseThrow();
      double y = shot.vehicle().y().orElseThrow();
      box[0] = Math.min(box[0], x);
      box[1] = Math.min(box[1], y);
      box[2] = Math.max(box[2], x);
      box[3] = Math.max(box[3], y);
    }
    return box;
  }

  /** How many echoes lie on or beside an occupied cell, and how many beams fly through one. */
  private static void score(OccupancyGrid grid, List<Shot> shots) {
    long echoes = 0;
    long explained = 0;
    long through = 0;
    for (Shot shot : shots) {
      SensorPose pose =
          SensorPose.of(shot.scan(), MapFrame.of(shot.vehicle()), Optional.of(shot.vehicle()));
      for (RangeScan.Beam beam : shot.scan().beams()) {
        if (beam.range().isEmpty()) {
          continue;
        }
        double range = beam.range().getAsDouble();
        echoes++;
        explained += occupiedNear(grid, pose.at(beam.angle(), range)) ? 1 : 0;
        boolean blocked = false;
        for (double r = 0.3; r < range - 0.3; r += grid.resolution()) {
          blocked |= grid.cellAt(pose.at(beam.angle(), r)) > 0;
        }
        through += blocked ? 1 : 0;
      }
    }
    long occupied = 0;
    long free = 0;
    for (byte cell : grid.cells()) {
      occupied += cell > 0 ? 1 : 0;
      free += cell < 0 && cell != OccupancyGrid.UNKNOWN ? 1 : 0;
    }
    double area = grid.resolution() * grid.resolution();
    System.out.printf(
        "%.2f %% of %d echoes on or beside an occupied cell; %.2f %% of beams cross one before their "
            + "end; occupied %.1f m2, free %.1f m2%n",
        100.0 * explained / echoes, echoes, 100.0 * through / echoes, occupied * area, free * area);
  }

  private static boolean occupiedNear(OccupancyGrid grid, Point point) {
    for (int i = -1; i <= 1; i++) {
      for (int k = -1; k <= 1; k++) {
        Point near =
            Point.of(
                point.x() + i * grid.resolution(), point.y() + k * grid.resolution(), point.z());
        if (grid.cellAt(near) > 0) {
          return true;
        }
      }
    }
    return false;
  }

  private static void draw(OccupancyGrid grid, File file) throws IOException {
    byte[] cells = grid.cells();
    int columns = grid.columns();
    int left = columns;
    int right = 0;
    int bottom = grid.rows();
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
