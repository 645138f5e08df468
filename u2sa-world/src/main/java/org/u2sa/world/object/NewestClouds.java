package org.u2sa.world.object;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.ObjectDescription;
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

  private record Seen(long micros, PointCloud cloud) {}

  private final Map<String, Seen> bySensor = new LinkedHashMap<>();
  private long refused;

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

  /** Clouds with at least one point and at most this age; 0: of any age. */
  List<PointCloud> clouds(long nowMicros, double forgetS) {
    if (forgetS > 0.0) {
      bySensor.values().removeIf(seen -> nowMicros - seen.micros() > Clock.micros(forgetS));
    }
    List<PointCloud> clouds = new ArrayList<>();
    for (Seen seen : bySensor.values()) {
      if (!seen.cloud().points().isEmpty()) {
        clouds.add(seen.cloud());
      }
    }
    return clouds;
  }

  void clear() {
    bySensor.clear();
  }

  String remark() {
    return (bySensor.isEmpty() ? "" : ", clouds of " + bySensor.size() + " scanners")
        + (refused == 0 ? "" : ", " + refused + " clouds rejected");
  }
}
