package org.u2sa.sim.detection;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.u2sa.device.detection.ObjectDetector;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.marine.Dock;
import org.u2sa.messages.marine.Hoop;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.Rectangle;
import org.u2sa.messages.shape.Sphere;
import org.u2sa.sim.device.NoisyDevice;
import org.u2sa.sim.device.SensorErrors;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Ray;
import org.u2sa.sim.world.Terrain;
import org.u2sa.sim.world.World;

/**
 * A detector that recognises typed objects of a world within its field of view unless other objects
 * hide them, with errors of bearing, elevation and range, and with misses.
 */
public final class SimulatedDetector extends NoisyDevice<ObjectDetector.Detections>
    implements ObjectDetector {
  /**
   * Properties.
   *
   * @param reachM maximum range [m]
   * @param waterReachM maximum range of objects under water or on the other side of its surface [m]
   * @param viewRad horizontal field of view [rad]
   * @param heightRad vertical field of view [rad]
   * @param angleSigmaRad standard deviation of bearing and elevation [rad]
   * @param rangeShare standard deviation of the range, as a fraction of it
   * @param missed fraction of objects that are missed, 0…1
   */
  public record Optics(
      double reachM,
      double waterReachM,
      double viewRad,
      double heightRad,
      double angleSigmaRad,
      double rangeShare,
      double missed) {}

  private static final double SURFACE_M = 0.05; // an object's own surface does not hide its centre

  private final Optics optics;
  private final Supplier<VehicleTruth> sensor;
  private final World world;

  /**
   * Uses the random stream {@code detector}.
   *
   * @param errors rate, latency and image loss; its sigma is not used
   * @param sensor current state of the sensor
   */
  public SimulatedDetector(
      SensorErrors errors,
      Optics optics,
      NoiseStreams streams,
      World world,
      Supplier<VehicleTruth> sensor) {
    super(errors, streams, "detector");
    this.optics = optics;
    this.world = world;
    this.sensor = sensor;
  }

  @Override
  protected Detections measure(double timeS, long measuredAtMicros) {
    VehicleTruth now = sensor.get();
    World scene = world.when(now.timeS());
    List<Detection> seen = new ArrayList<>();
    for (ObjectDescription object : scene.obstacles()) {
      if (!object.objectType().isEmpty()) {
        see(object, now, scene, seen);
      }
    }
    return new Detections(measuredAtMicros, List.copyOf(seen));
  }

  private void see(ObjectDescription object, VehicleTruth now, World scene, List<Detection> seen) {
    Point centre = enu(object, scene);
    Point way = centre.minus(now.position());
    double range = way.distance();
    boolean throughWater = centre.z() < 0.0 || now.position().z() < 0.0;
    if (range == 0.0 || range > (throughWater ? optics.waterReachM() : optics.reachM())) {
      return;
    }
    Point frd =
        now.attitude().nedFromFrd().transposed().times(Point.of(way.y(), way.x(), -way.z()));
    double bearing = Math.atan2(-frd.y(), frd.x());
    double elevation = Math.atan2(-frd.z(), Math.hypot(frd.x(), frd.y()));
    if (Math.abs(bearing) > optics.viewRad() / 2.0
        || Math.abs(elevation) > optics.heightRad() / 2.0
        || uniform() < optics.missed()
        || isHidden(object, way, range, now.position(), scene)) {
      return;
    }
    seen.add(
        new Detection(
            object.objectType(),
            bearing + optics.angleSigmaRad() * gaussian(),
            elevation + optics.angleSigmaRad() * gaussian(),
            Math.max(0.0, range * (1.0 + optics.rangeShare() * gaussian())),
            optics.angleSigmaRad(),
            optics.rangeShare() * range,
            radiusM(object),
            axis(object, scene).map(axis -> turned(axis, now))));
  }

  /** A level direction, clockwise from north [rad], in the sensor's axes forward, left, down. */
  private Point turned(double axisRad, VehicleTruth now) {
    double seenRad = axisRad + optics.angleSigmaRad() * gaussian();
    Point ned = Point.of(Math.cos(seenRad), Math.sin(seenRad), 0.0);
    Point frd = now.attitude().nedFromFrd().transposed().times(ned);
    return Point.of(frd.x(), -frd.y(), frd.z());
  }

  /** Direction of an object's length or normal, clockwise from north [rad]. */
  private static Optional<Double> axis(ObjectDescription object, World scene) {
    double psi;
    if (object instanceof Rectangle flat) {
      psi = flat.psi();
    } else if (object instanceof Box box) {
      psi = box.psi();
    } else if (object instanceof Hoop hoop && !hoop.lying()) {
      psi = hoop.psi();
    } else {
      return Optional.empty();
    }
    return Optional.of(object.referenceFrame().isEarth() ? psi : Math.PI / 2.0 - psi);
  }

  private static Point enu(ObjectDescription object, World scene) {
    return object.referenceFrame().isEarth()
        ? scene.plane().point(Geodetic.of(object.in(ReferenceFrame.GLOBAL, null).center()))
        : object.in(ReferenceFrame.LOCAL_ENU, null).center();
  }

  private static boolean isHidden(
      ObjectDescription object, Point way, double range, Point from, World scene) {
    Point to = way.times(1.0 / range);
    Ray ray = new Ray(from.x(), from.y(), from.z(), to.x(), to.y(), to.z());
    double free = range - radiusM(object) - SURFACE_M;
    Optional<World.Hit> hit = free > 0.0 ? scene.cast(ray, free) : Optional.empty();
    if (hit.isEmpty()) {
      return false;
    }
    if (hit.get().object().isEmpty()) { // with water, its surface
      return scene.water().isEmpty() || scene.terrain() != Terrain.flat();
    }
    return !hit.get().object().get().equals(object);
  }

  private static double radiusM(ObjectDescription object) {
    return object instanceof Sphere ball
        ? ball.radius()
        : object instanceof Cylinder pillar
            ? pillar.radius()
            : object instanceof Hoop hoop
                ? hoop.radius()
                : object instanceof Dock dock ? 0.5 * dock.width() : 0.0;
  }
}
