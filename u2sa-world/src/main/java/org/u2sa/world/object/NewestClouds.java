package org.u2sa.world.object;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.Metric;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.PointCloud;
import org.u2sa.world.modeller.Sighting;

/**
 * The newest scan of each sensor that publishes its scans as point clouds, at the position of the
 * scan. Such a cloud is not an object: its position is the point nearest to the scanner, which
 * moves along a wall with the vehicle.
 */
final class NewestClouds {
  private static final int MAX_SENSORS = 32;

  /** Fraction of the heap for clouds from other processes. */
  private static final int HEAP_PART = 8;

  /** Points of all clouds; 40 bytes each, of the 1 MiB that readers of a list accept. */
  static final int MAX_POINTS = 20_000;

  private record Seen(long micros, PointCloud cloud) {}

  private final Map<String, Seen> bySensor = new LinkedHashMap<>();
  private long refused;
  private int left; // points left out of the last list

  static boolean takes(ObjectDescription seen) {
    return seen instanceof PointCloud cloud && cloud.isScan();
  }

  void put(PointCloud cloud, Sighting sighting) {
    boolean isNew = !bySensor.containsKey(cloud.sensorName());
    long share = Runtime.getRuntime().maxMemory() / HEAP_PART / MAX_SENSORS;
    if (cloud.receivedBytes() > share || isNew && bySensor.size() == MAX_SENSORS) {
      refused++;
      return;
    }
    sighting
        .frame()
        .placed(cloud, sighting.vehicle())
        .ifPresent(
            placed ->
                bySensor.put(cloud.sensorName(), new Seen(sighting.micros(), (PointCloud) placed)));
  }

  /**
   * Clouds with at least one point and at most this age; 0: of any age. Of too many points, those
   * nearest to the vehicle.
   */
  List<PointCloud> clouds(Sighting now, double forgetS) {
    if (forgetS > 0.0) {
      bySensor.values().removeIf(seen -> now.micros() - seen.micros() > Clock.micros(forgetS));
    }
    List<PointCloud> clouds = new ArrayList<>();
    for (Seen seen : bySensor.values()) {
      if (!seen.cloud().points().isEmpty()) {
        clouds.add(seen.cloud());
      }
    }
    int points = clouds.stream().mapToInt(cloud -> cloud.points().size()).sum();
    left = Math.max(0, points - MAX_POINTS);
    return left == 0 ? clouds : nearest(clouds, now);
  }

  private static List<PointCloud> nearest(List<PointCloud> clouds, Sighting now) {
    Point here =
        now.vehicle()
            .map(at -> Point.of(at.x().orElse(0.0), at.y().orElse(0.0), at.z().orElse(0.0)))
            .orElse(Point.ORIGIN);
    List<double[]> awayM = new ArrayList<>();
    for (PointCloud cloud : clouds) {
      Metric metric = Metric.around(cloud.referenceFrame(), here);
      awayM.add(
          cloud.points().stream().mapToDouble(each -> metric.metres(each).distance()).toArray());
    }
    double[] sorted = awayM.stream().flatMapToDouble(Arrays::stream).sorted().toArray();
    double limitM = sorted[MAX_POINTS];
    List<PointCloud> near = new ArrayList<>();
    for (int i = 0; i < clouds.size(); i++) {
      List<Point> kept = new ArrayList<>();
      for (int k = 0; k < awayM.get(i).length; k++) {
        if (awayM.get(i)[k] < limitM) {
          kept.add(clouds.get(i).points().get(k));
        }
      }
      if (!kept.isEmpty()) {
        near.add(((PointCloud) clouds.get(i).copy()).points(kept));
      }
    }
    return near;
  }

  void clear() {
    bySensor.clear();
  }

  String remark() {
    return (bySensor.isEmpty() ? "" : ", clouds of " + bySensor.size() + " scanners")
        + (refused == 0 ? "" : ", " + refused + " clouds rejected")
        + (left == 0 ? "" : ", " + left + " points too far away left out");
  }
}
