package org.u2sa.world.object;

import java.util.ArrayList;
import java.util.Comparator;
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
   * Clouds with at least one point and at most this age; 0: of any age. Of too many points, each
   * sensor has the same share, and keeps its nearest ones: otherwise one sensor with many points
   * would hide what the others see.
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
    int all = clouds.stream().mapToInt(cloud -> cloud.points().size()).sum();
    left = Math.max(0, all - MAX_POINTS);
    return left == 0 ? clouds : reduced(clouds, now);
  }

  /** Small clouds are whole; the others share what these leave. */
  private static List<PointCloud> reduced(List<PointCloud> clouds, Sighting now) {
    List<PointCloud> bySize = new ArrayList<>(clouds);
    bySize.sort(Comparator.comparingInt(cloud -> cloud.points().size()));
    List<PointCloud> reduced = new ArrayList<>();
    int room = MAX_POINTS;
    for (int i = 0; i < bySize.size(); i++) {
      PointCloud cloud = bySize.get(i);
      int share = Math.min(cloud.points().size(), room / (bySize.size() - i));
      room -= share;
      reduced.add(nearest(cloud, share, now));
    }
    return reduced;
  }

  private static PointCloud nearest(PointCloud cloud, int count, Sighting now) {
    if (count == cloud.points().size()) {
      return cloud;
    }
    Point here =
        now.vehicle()
            .map(at -> Point.of(at.x().orElse(0.0), at.y().orElse(0.0), at.z().orElse(0.0)))
            .orElse(Point.ORIGIN);
    Metric metric = Metric.around(cloud.referenceFrame(), here);
    List<Point> near = new ArrayList<>(cloud.points());
    near.sort(Comparator.comparingDouble(point -> metric.metres(point).distance()));
    return ((PointCloud) cloud.copy()).points(List.copyOf(near.subList(0, count)));
  }

  void clear() {
    bySensor.clear();
  }

  String remark() {
    return (bySensor.isEmpty() ? "" : ", clouds of " + bySensor.size() + " scanners")
        + (refused == 0 ? "" : ", " + refused + " clouds rejected")
        + (left == 0 ? "" : ", " + left + " points left out");
  }
}
