package org.u2sa.world;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.PointCloud;
import org.u2sa.service.handover.HandOver;
import org.u2sa.world.modeller.Modeller;
import org.u2sa.world.modeller.ScanPoses;
import org.u2sa.world.modeller.Sighting;

/**
 * Publishes the latest detections of each sensor, in their original frames (thesis 4.1.1.2), with
 * scans as point clouds, together with the a priori objects.
 */
final class ReactiveModeller implements Modeller {
  private record Variables(
      @Variable(unit = "s", min = 0.01, max = 3600, ifAbsent = 1)
          @Description("REACTIVE: time after which a sensor's latest sighting is dropped.")
          double memory,
      @Variable(ifAbsentText = "true")
          @Description(
              "REACTIVE: whether a scan's echoes are published as a point cloud among the objects.")
          boolean scansAsObjects) {}

  private record Memory(long micros, List<ObjectDescription> objects) {}

  private final Settings<Variables> tuning;
  private final Map<String, Memory> bySensor = new TreeMap<>();
  private List<ObjectDescription> known = List.of();
  private long knownMicros;

  ReactiveModeller(Configurator configuration) {
    tuning = configuration.settings(Variables.class);
  }

  @Override
  public void objects(List<ObjectDescription> seen, Sighting sighting) {
    List<ObjectDescription> objects = new ArrayList<>(seen);
    objects.removeIf(each -> each instanceof PointCloud cloud && cloud.points().isEmpty());
    bySensor.put(seen.get(0).sensorName(), new Memory(sighting.micros(), objects));
  }

  @Override
  public void scan(RangeScan scan, ScanPoses poses) {
    List<Point> points =
        tuning.get().scansAsObjects() && scan.referenceFrame().equals(ReferenceFrame.BODY)
            ? scan.points()
            : List.of();
    if (points.isEmpty()) {
      bySensor.remove(scan.sensorName());
      return;
    }
    Point nearest = points.get(0);
    for (Point point : points) {
      nearest = point.distance() < nearest.distance() ? point : nearest;
    }
    PointCloud cloud = new PointCloud().points(points);
    cloud
        .uid(scan.sensorName())
        .referenceFrame(ReferenceFrame.BODY)
        .x(nearest.x())
        .y(nearest.y())
        .z(nearest.z())
        .sensorName(scan.sensorName());
    cloud.timestamp(poses.first().micros());
    bySensor.put(scan.sensorName(), new Memory(poses.first().micros(), List.of(cloud)));
  }

  @Override
  public void known(List<ObjectDescription> objects, Sighting now) {
    known = List.copyOf(objects);
    knownMicros = now.micros();
  }

  @Override
  public boolean publishesKnown() {
    return true;
  }

  @Override
  public List<ObjectDescription> objects(Sighting now) {
    long oldest = now.micros() - Clock.micros(tuning.get().memory());
    bySensor.values().removeIf(memory -> memory.micros() < oldest);
    Map<String, ObjectDescription> byUid = new LinkedHashMap<>();
    double sinceS = Clock.seconds(now.micros() - knownMicros);
    known.forEach(object -> byUid.put(object.uid(), object.after(sinceS)));
    for (Memory memory : bySensor.values()) {
      memory.objects().forEach(object -> byUid.put(object.uid(), object));
    }
    return new ArrayList<>(byUid.values());
  }

  @Override
  public String remark() {
    return bySensor.size() + " sensors, " + known.size() + " objects known beforehand";
  }

  @Override
  public void handOver(HandOver state, Sighting now) {
    List<ObjectDescription> seen = new ArrayList<>();
    bySensor.values().forEach(memory -> seen.addAll(memory.objects()));
    state.messages("OBJECTS", seen);
  }

  @Override
  public void takeOver(HandOver state, Sighting now) {
    for (ObjectDescription object : state.messages("OBJECTS", ObjectDescription.class)) {
      List<ObjectDescription> objects = new ArrayList<>();
      Memory before = bySensor.get(object.sensorName());
      if (before != null) {
        objects.addAll(before.objects());
      }
      objects.add(object);
      bySensor.put(object.sensorName(), new Memory(now.micros(), objects));
    }
  }
}
