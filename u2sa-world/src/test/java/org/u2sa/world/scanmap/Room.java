package org.u2sa.world.scanmap;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import org.u2sa.messages.RangeScan;

/** Walls in the plane and what a laser sees of them. */
final class Room {
  private static final int BEAMS = 360;

  private final List<double[]> walls = new ArrayList<>(); // x1, y1, x2, y2

  /** A room of 8 m by 6 m with a niche, a cupboard and a pillar. */
  static Room furnished() {
    Room room = new Room();
    room.outline(0.0, 0.0, 8.0, 0.0, 8.0, 3.5, 8.6, 3.5, 8.6, 4.5, 8.0, 4.5, 8.0, 6.0, 0.0, 6.0);
    room.outline(2.0, 6.0, 2.0, 5.2, 3.4, 5.2, 3.4, 6.0);
    room.outline(5.5, 1.0, 6.0, 1.0, 6.0, 1.5, 5.5, 1.5);
    return room;
  }

  /** A hall of 14 m by 11 m with a long table and a pillar in a corner. */
  static Room hall() {
    Room room = bare(14.0, 11.0);
    room.outline(5.5, 5.0, 8.5, 5.0, 8.5, 6.0, 5.5, 6.0);
    room.outline(12.7, 1.2, 13.3, 1.2, 13.3, 1.8, 12.7, 1.8);
    return room;
  }

  /** A room without furniture: it looks the same turned by half a turn. */
  static Room bare(double lengthM, double widthM) {
    Room room = new Room();
    room.outline(0.0, 0.0, lengthM, 0.0, lengthM, widthM, 0.0, widthM);
    return room;
  }

  /** Two parallel walls, longer than a laser reaches. */
  static Room corridor() {
    Room room = new Room();
    room.walls.add(new double[] {-100.0, 0.0, 100.0, 0.0});
    room.walls.add(new double[] {-100.0, 2.0, 100.0, 2.0});
    return room;
  }

  /** A corridor of 46 m by 3 m with pillars on both sides, one like the other. */
  static Room pillars(double everyM) {
    Room room = new Room();
    room.outline(-5.0, -1.5, 41.0, -1.5, 41.0, 1.5, -5.0, 1.5);
    for (double x = -4.0; x < 40.5; x += everyM) {
      room.outline(x, -1.5, x, -1.15, x + 0.3, -1.15, x + 0.3, -1.5);
      room.outline(x, 1.5, x, 1.15, x + 0.3, 1.15, x + 0.3, 1.5);
    }
    return room;
  }

  private void outline(double... corners) {
    for (int i = 0; i < corners.length; i += 2) {
      int next = (i + 2) % corners.length;
      walls.add(new double[] {corners[i], corners[i + 1], corners[next], corners[next + 1]});
    }
  }

  /** Range of each of 360 beams, counter-clockwise from straight back; above reach if none. */
  double[] ranges(Pose2 pose, double reach, double sigma, Random random) {
    double[] ranges = new double[BEAMS];
    for (int i = 0; i < BEAMS; i++) {
      double angle = pose.theta() - Math.PI + 2.0 * Math.PI * i / BEAMS;
      double range = Double.POSITIVE_INFINITY;
      for (double[] wall : walls) {
        range = Math.min(range, hit(pose, Math.cos(angle), Math.sin(angle), wall));
      }
      ranges[i] = range > reach ? Double.POSITIVE_INFINITY : range + sigma * random.nextGaussian();
    }
    return ranges;
  }

  private static double hit(Pose2 from, double c, double s, double[] wall) {
    double ex = wall[2] - wall[0];
    double ey = wall[3] - wall[1];
    double across = c * ey - s * ex;
    double dx = wall[0] - from.x();
    double dy = wall[1] - from.y();
    double along = (dx * ey - dy * ex) / across;
    double share = (dx * s - dy * c) / across;
    return along > 0.0 && share >= 0.0 && share <= 1.0 ? along : Double.POSITIVE_INFINITY;
  }

  /** Echoes in the vehicle's axes. */
  ScanPoints points(Pose2 pose, double reach, double sigma, Random random) {
    double[] ranges = ranges(pose, reach, sigma, random);
    double[] x = new double[BEAMS];
    double[] y = new double[BEAMS];
    int count = 0;
    for (int i = 0; i < BEAMS; i++) {
      if (ranges[i] < reach) {
        double angle = -Math.PI + 2.0 * Math.PI * i / BEAMS;
        x[count] = ranges[i] * Math.cos(angle);
        y[count++] = ranges[i] * Math.sin(angle);
      }
    }
    return ScanPoints.of(java.util.Arrays.copyOf(x, count), java.util.Arrays.copyOf(y, count));
  }

  /** The same as a message; its angles turn counter-clockwise, so the map's axes are ENU. */
  RangeScan scan(Pose2 pose, double reach, double sigma, Random random) {
    List<OptionalDouble> ranges = new ArrayList<>();
    for (double range : ranges(pose, reach, sigma, random)) {
      ranges.add(range < reach ? OptionalDouble.of(range) : OptionalDouble.empty());
    }
    return new RangeScan()
        .sensorName("Lidar")
        .maxRange(reach)
        .beams(-Math.PI, 2.0 * Math.PI / BEAMS, ranges);
  }
}
