package org.u2sa.world.scanmap;

import java.util.List;
import org.u2sa.messages.RangeScan;
import org.u2sa.world.grid.ScanEntry;
import org.u2sa.world.modeller.ScanPoses;
import org.u2sa.world.modeller.SensorPose;

/**
 * Echoes of one scan in the vehicle's plane, with surface normals where neighbouring echoes lie on
 * a surface.
 */
final class ScanPoints {
  private static final int PARTS = 8;
  private static final double SURFACE_GAP = 0.15; // between neighbouring echoes of a surface [m]
  private static final double GAP_PER_METRE = 0.06; // 1° beams, at grazing angles
  private static final double SPAN = 0.25; // minimum distance of neighbours to estimate a normal
  private static final double FRONT_M = 0.3; // minimum distance of a pole from its background
  private static final double MAX_BEND =
      0.15; // deviation from the line through the neighbours, per metre

  final int count;
  final double[] x;
  final double[] y;
  final double[] nx; // NaN: no surface
  final double[] ny;
  final boolean[]
      loose; // neither on a surface nor an isolated object: carries no information about the pose

  private ScanPoints(int count) {
    this.count = count;
    x = new double[count];
    y = new double[count];
    nx = new double[count];
    ny = new double[count];
    loose = new boolean[count];
  }

  /** Points given by coordinates, in the order of the beams. */
  static ScanPoints of(double[] xs, double[] ys) {
    ScanPoints points = new ScanPoints(xs.length);
    System.arraycopy(xs, 0, points.x, 0, xs.length);
    System.arraycopy(ys, 0, points.y, 0, ys.length);
    points.findSurfaces();
    return points;
  }

  /**
   * Obstacle echoes of a scan, thinned to about the given number of points.
   *
   * @param vehicle pose of the vehicle at the first beam, in the map of the poses
   * @param reach range beyond which echoes are dropped [m]
   */
  static ScanPoints of(
      RangeScan scan,
      ScanPoses poses,
      Pose2 vehicle,
      ScanEntry.Band band,
      double up,
      double reach,
      int wanted) {
    List<RangeScan.Beam> beams = scan.beams();
    int parts = poses.moved() ? PARTS : 1;
    double[] xs = new double[beams.size()];
    double[] ys = new double[beams.size()];
    int used = 0;
    double c = StrictMath.cos(vehicle.theta());
    double s = StrictMath.sin(vehicle.theta());
    for (int part = 0; part < parts; part++) {
      int from = beams.size() * part / parts;
      int to = beams.size() * (part + 1) / parts;
      SensorPose pose =
          poses.at(scan, parts == 1 ? 0.0 : (from + to) / 2.0 / Math.max(1, beams.size()));
      for (int i = from; i < to; i++) {
        double range = beams.get(i).range().orElse(-1.0);
        if (range < scan.minRange() || range <= 0.0 || range > reach) {
          continue;
        }
        var end = pose.at(beams.get(i).angle(), range);
        double height = up * (end.z() - pose.vehicle().z());
        if (height >= band.lowest() && height <= band.highest()) {
          double dx = end.x() - vehicle.x();
          double dy = end.y() - vehicle.y();
          xs[used] = c * dx + s * dy;
          ys[used++] = c * dy - s * dx;
        }
      }
    }
    int every = Math.max(1, (used + wanted - 1) / wanted);
    ScanPoints points = new ScanPoints((used + every - 1) / every);
    for (int i = 0; i < points.count; i++) {
      points.x[i] = xs[i * every];
      points.y[i] = ys[i * every];
    }
    points.findSurfaces();
    return points;
  }

  private void findSurfaces() {
    for (int i = 0; i < count; i++) {
      int a = neighbour(i, -1);
      int b = neighbour(i, 1);
      double dx = x[b] - x[a];
      double dy = y[b] - y[a];
      double length = Math.hypot(dx, dy);
      double off = Math.abs(dx * (y[i] - y[a]) - dy * (x[i] - x[a])) / Math.max(length, 1e-9);
      if (a == b || length < SPAN / 2.0 || off > 0.02 + MAX_BEND * length) {
        nx[i] = Double.NaN;
        ny[i] = Double.NaN;
        loose[i] = !isInFront(i);
        continue;
      }
      double side = dx * y[i] - dy * x[i] > 0.0 ? -1.0 : 1.0; // towards the vehicle
      nx[i] = side * -dy / length;
      ny[i] = side * dx / length;
    }
  }

  /**
   * Whether both neighbours are farther away, as beside a pole. On a wall seen at a grazing angle,
   * one of the two neighbours is nearer instead.
   */
  private boolean isInFront(int i) {
    if (i == 0 || i + 1 == count) {
      return false;
    }
    double range = Math.hypot(x[i], y[i]) + FRONT_M;
    return Math.hypot(x[i - 1], y[i - 1]) > range && Math.hypot(x[i + 1], y[i + 1]) > range;
  }

  /** Farthest echo of the same surface on one side, up to the span needed to estimate a normal. */
  private int neighbour(int i, int step) {
    int at = i;
    for (int k = i + step; k >= 0 && k < count; k += step) {
      double gap = Math.hypot(x[k] - x[at], y[k] - y[at]);
      if (gap > SURFACE_GAP + GAP_PER_METRE * Math.hypot(x[k], y[k])) {
        break;
      }
      at = k;
      if (Math.hypot(x[k] - x[i], y[k] - y[i]) >= SPAN) {
        break;
      }
    }
    return at;
  }

  /** Merges several scans taken at different poses. */
  static ScanPoints joined(List<KeyScan> scans, Pose2 seenFrom) {
    int total = scans.stream().mapToInt(scan -> scan.points().count).sum();
    ScanPoints all = new ScanPoints(total);
    int at = 0;
    for (KeyScan scan : scans) {
      Pose2 pose = scan.pose().from(seenFrom);
      double c = StrictMath.cos(pose.theta());
      double s = StrictMath.sin(pose.theta());
      ScanPoints each = scan.points();
      for (int i = 0; i < each.count; i++, at++) {
        all.x[at] = pose.x() + c * each.x[i] - s * each.y[i];
        all.y[at] = pose.y() + s * each.x[i] + c * each.y[i];
        all.nx[at] = c * each.nx[i] - s * each.ny[i];
        all.loose[at] = each.loose[i];
        all.ny[at] = s * each.nx[i] + c * each.ny[i];
      }
    }
    return all;
  }
}
