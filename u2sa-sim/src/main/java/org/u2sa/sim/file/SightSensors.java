package org.u2sa.sim.file;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.function.ToDoubleBiFunction;
import java.util.function.ToDoubleFunction;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.sim.detection.SimulatedDetector;
import org.u2sa.sim.device.SensorErrors;
import org.u2sa.sim.device.SimulatedCamera;
import org.u2sa.sim.device.SimulatedHydrophoneTimes;
import org.u2sa.sim.device.SimulatedHydrophones;
import org.u2sa.sim.device.SimulatedLaser;
import org.u2sa.sim.device.SimulatedPointScanner;
import org.u2sa.sim.device.SimulatedRadar;
import org.u2sa.sim.device.SimulatedRangeFinder;
import org.u2sa.sim.device.SimulatedSonar;
import org.u2sa.sim.device.SimulatedTraffic;
import org.u2sa.sim.file.element.FileElement;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Ray;
import org.u2sa.sim.world.ScriptedMover;
import org.u2sa.sim.world.Terrain;
import org.u2sa.sim.world.World;

/** Sensors of the surroundings. */
final class SightSensors {
  private static final int MAX_HYDROPHONES = 32;
  private static final int MAX_BEAMS = 20_000;
  private static final int MAX_PIXELS = 4_000;
  private static final double RADAR_TIP_M = 1.0; // ends before the ground under a target

  private SightSensors() {}

  static SensorKinds.Reader laser(FileElement file) {
    double rate = file.number("rate", "Hz", 0.1, 1_000.0);
    double first = file.number("firstAngle", "rad", -2.0 * Math.PI, 2.0 * Math.PI);
    double step = file.number("stepAngle", "rad", -1.0, 1.0);
    int beams = file.count("beams", 1, MAX_BEAMS);
    double nearest = file.number("minRange", "m", 0.0, 1_000.0);
    double farthest = file.positive("maxRange", "m", 1_000.0);
    double sigma = file.number("sigma", "m", 0.0, 100.0);
    double noEcho = file.number("noEcho", "1", 0.0, 1.0, 0.0);
    double mixed = file.number("mixed", "1", 0.0, 1.0, 0.0);
    Mount mount = Mount.pose(file);
    SimulatedLaser.Optics optics =
        new SimulatedLaser.Optics(rate, first, step, beams, nearest, farthest, sigma);
    SimulatedLaser.Faults faults = new SimulatedLaser.Faults(noEcho, mixed);
    return new SensorKinds.Reader(
        mounted(mount),
        vehicle ->
            new SimulatedLaser(
                optics,
                faults,
                vehicle.streams(),
                sight(light(vehicle.world(), vehicle.at(mount), farthest))));
  }

  /** The services' MOUNTED variables, whose y, roll and yaw are positive to the left. */
  private static Map<String, Double> mounted(Mount mount) {
    return Map.of(
        "MOUNTED X",
        mount.place().x(),
        "MOUNTED Y",
        -mount.place().y() + 0.0,
        "MOUNTED Z",
        mount.place().z(),
        "MOUNTED ROLL",
        -mount.turn().x() + 0.0,
        "MOUNTED PITCH",
        mount.turn().y(),
        "MOUNTED YAW",
        -mount.turn().z() + 0.0);
  }

  private static Supplier<SimulatedLaser.Sight> sight(
      World world, Supplier<VehicleTruth> sensor, double rangeM) {
    return sight(view(world, sensor, rangeM));
  }

  private static Supplier<SimulatedLaser.Sight> sight(Supplier<ToDoubleFunction<Point>> space) {
    return () -> {
      ToDoubleFunction<Point> now = space.get();
      return (angleRad, cos, sin) -> now.applyAsDouble(Point.of(cos, sin, 0.0));
    };
  }

  /**
   * Optical ranges along unit vectors ahead, left and down. Open water returns no echo: it reflects
   * a beam away at a grazing angle and absorbs it otherwise.
   */
  private static Supplier<ToDoubleFunction<Point>> light(
      World world, Supplier<VehicleTruth> sensor, double rangeM) {
    boolean isOpenWater = world.water().isPresent() && world.terrain() == Terrain.flat();
    return isOpenWater
        ? view(sensor, world, (seen, ray) -> ofObject(seen, ray, rangeM))
        : view(world, sensor, rangeM);
  }

  private static double ofObject(World seen, Ray ray, double rangeM) {
    return seen.cast(ray, rangeM)
        .filter(hit -> hit.object().isPresent())
        .map(World.Hit::distanceM)
        .orElse(Double.POSITIVE_INFINITY);
  }

  /** Ranges along unit vectors ahead, left and down. */
  private static Supplier<ToDoubleFunction<Point>> view(
      World world, Supplier<VehicleTruth> sensor, double rangeM) {
    return view(sensor, world, (seen, ray) -> seen.distanceM(ray, rangeM));
  }

  private static Supplier<ToDoubleFunction<Point>> view(
      Supplier<VehicleTruth> sensor, World world, ToDoubleBiFunction<World, Ray> range) {
    return () -> {
      VehicleTruth now = sensor.get();
      Rotation nedFromFrd = now.attitude().nedFromFrd();
      Point from = now.position();
      World seen = world.when(now.timeS());
      return direction -> {
        Point way = nedFromFrd.times(Point.of(direction.x(), -direction.y(), direction.z()));
        Ray ray = new Ray(from.x(), from.y(), from.z(), way.y(), way.x(), -way.z());
        return range.applyAsDouble(seen, ray);
      };
    };
  }

  static SensorKinds.Reader pointScanner(FileElement file) {
    double farthest = file.positive("maxRange", "m", 1_000.0);
    SimulatedPointScanner.Optics optics =
        new SimulatedPointScanner.Optics(
            file.number("rate", "Hz", 0.1, 100.0),
            file.number("width", "rad", 0.01, 2.0 * Math.PI),
            file.count("columns", 1, MAX_PIXELS),
            file.number("height", "rad", 0.0, Math.PI),
            file.count("rows", 1, MAX_PIXELS),
            file.number("minRange", "m", 0.0, 1_000.0),
            farthest,
            file.number("sigma", "m", 0.0, 100.0));
    Mount mount = Mount.pose(file);
    return new SensorKinds.Reader(
        mounted(mount),
        vehicle ->
            new SimulatedPointScanner(
                optics, vehicle.streams(), light(vehicle.world(), vehicle.at(mount), farthest)));
  }

  static SensorKinds.Reader sonar(FileElement file) {
    SimulatedSonar.Head head =
        new SimulatedSonar.Head(
            file.number("rate", "Hz", 0.1, 1_000.0),
            file.number("stepAngle", "rad", -Math.PI, Math.PI),
            file.count("samples", 1, 10_000),
            file.positive("maxRange", "m", 1_000.0));
    Mount mount = Mount.pose(file);
    return new SensorKinds.Reader(
        mounted(mount),
        vehicle -> {
          Supplier<SimulatedLaser.Sight> sight =
              sight(vehicle.world(), vehicle.at(mount), head.reachM());
          return new SimulatedSonar(
              head,
              vehicle.streams(),
              angle -> sight.get().distanceM(angle, StrictMath.cos(angle), StrictMath.sin(angle)));
        });
  }

  static SensorKinds.Reader rangeFinder(FileElement file) {
    double rate = file.number("rate", "Hz", 0.1, 1_000.0);
    double farthest = file.positive("maxRange", "m", 1_000.0);
    double sigma = file.number("sigma", "m", 0.0, 100.0);
    Mount mount = Mount.pose(file);
    return new SensorKinds.Reader(
        mounted(mount),
        vehicle -> {
          Supplier<SimulatedLaser.Sight> sight =
              sight(vehicle.world(), vehicle.at(mount), farthest);
          return new SimulatedRangeFinder(
              "range finder",
              rate,
              farthest,
              sigma,
              vehicle.streams(),
              () -> sight.get().distanceM(0.0, 1.0, 0.0));
        });
  }

  static SensorKinds.Reader radar(FileElement file) {
    SensorErrors errors = StateSensors.errors(file, "m");
    double reach = file.positive("reach", "m", 1e6);
    double angleSigma = file.number("angleSigma", "rad", 0.0, 1.0);
    Mount mount = Mount.place(file);
    return new SensorKinds.Reader(
        vehicle ->
            new SimulatedRadar(
                errors,
                reach,
                angleSigma,
                vehicle.streams(),
                vehicle.at(mount),
                () -> inSight(vehicle.world(), vehicle.at(mount).get())));
  }

  static SensorKinds.Reader detector(FileElement file) {
    SensorErrors errors =
        new SensorErrors(
            file.number("rate", "Hz", 0.1, 100.0),
            file.number("delay", "s", 0.0, 60.0),
            0.0,
            0.0,
            file.number("dropouts", "1", 0.0, 1.0, 0.0));
    double reach = file.positive("reach", "m", 10_000.0);
    SimulatedDetector.Optics optics =
        new SimulatedDetector.Optics(
            reach,
            file.number("waterReach", "m", 0.0, 10_000.0, reach),
            file.number("view", "rad", 0.01, 2.0 * Math.PI),
            file.number("height", "rad", 0.01, Math.PI),
            file.number("angleSigma", "rad", 0.0, 1.0),
            file.number("rangeShare", "1", 0.0, 1.0),
            file.number("missed", "1", 0.0, 1.0, 0.0));
    Mount mount = Mount.pose(file);
    return new SensorKinds.Reader(
        mounted(mount),
        vehicle ->
            new SimulatedDetector(
                errors, optics, vehicle.streams(), vehicle.world(), vehicle.at(mount)));
  }

  static SensorKinds.Reader trafficReceiver(FileElement file) {
    SensorErrors errors = StateSensors.errors(file, "m");
    double reach = file.positive("reach", "m", 1e6);
    return new SensorKinds.Reader(
        vehicle ->
            new SimulatedTraffic(
                errors,
                reach,
                vehicle.world().plane(),
                vehicle.streams(),
                () -> vehicle.truth().get().position(),
                () -> heard(vehicle)));
  }

  /** Other vehicles of the run, and movers with a transponder. */
  private static List<SimulatedTraffic.Other> heard(Aboard vehicle) {
    double timeS = vehicle.truth().get().timeS();
    List<SimulatedTraffic.Other> all = new ArrayList<>(vehicle.traffic().get());
    vehicle.world().movers().stream()
        .filter(ScriptedMover::hasTransponder)
        .forEach(mover -> all.add(other(mover, timeS)));
    return all;
  }

  private static SimulatedTraffic.Other other(ScriptedMover mover, double timeS) {
    ScriptedMover.State state = mover.at(timeS);
    return new SimulatedTraffic.Other(
        mover.uid(), mover.objectType(), state.position(), state.velocity());
  }

  /** Movers not hidden by ground or obstacles. */
  private static List<SimulatedTraffic.Other> inSight(World world, VehicleTruth sensor) {
    Point from = sensor.position();
    return world.movers().stream()
        .map(mover -> other(mover, sensor.timeS()))
        .filter(
            other -> {
              Point way = other.position().minus(from);
              double distance = way.distance();
              Point to = distance > 0.0 ? way.times(1.0 / distance) : Point.of(1.0, 0.0, 0.0);
              Ray ray = new Ray(from.x(), from.y(), from.z(), to.x(), to.y(), to.z());
              double tip = Math.max(0.0, distance - RADAR_TIP_M);
              return Double.isInfinite(world.distanceM(ray, tip));
            })
        .toList();
  }

  static SensorKinds.Reader hydrophones(FileElement file) {
    if (file.has("places")) {
      return hydrophoneTimes(file);
    }
    SensorErrors errors = StateSensors.errors(file, "rad");
    double frequency = file.positive("frequency", "Hz", 1e6);
    Point pinger = file.vector("pinger", "m", -1e6, 1e6);
    Mount mount = Mount.pose(file);
    return new SensorKinds.Reader(
        mounted(mount),
        vehicle ->
            new SimulatedHydrophones(
                errors, frequency, pinger, vehicle.streams(), vehicle.at(mount)));
  }

  private static SensorKinds.Reader hydrophoneTimes(FileElement file) {
    SensorErrors errors = StateSensors.errors(file, "s");
    List<Double> numbers = file.numbers("places", "m", -100.0, 100.0, 3 * MAX_HYDROPHONES);
    List<Point> places = new ArrayList<>();
    for (int i = 0; i + 2 < numbers.size(); i += 3) {
      places.add(Point.of(numbers.get(i), -numbers.get(i + 1) + 0.0, numbers.get(i + 2)));
    }
    SimulatedHydrophoneTimes.Source source =
        new SimulatedHydrophoneTimes.Source(
            file.positive("frequency", "Hz", 1e6),
            file.vector("pinger", "m", -1e6, 1e6),
            file.number("soundSpeed", "m/s", 1_000.0, 2_000.0, 1_500.0),
            file.number("echoes", "1", 0.0, 1.0, 0.0));
    Mount mount = Mount.pose(file);
    return new SensorKinds.Reader(
        mounted(mount),
        vehicle ->
            new SimulatedHydrophoneTimes(
                errors, source, places, vehicle.streams(), vehicle.at(mount)));
  }

  static SensorKinds.Reader camera(FileElement file) {
    if (file.has("picture")) {
      Mount mount = Mount.pose(file);
      return RenderedCameras.read(file, mounted(mount), mount);
    }
    SimulatedCamera.Lens lens =
        new SimulatedCamera.Lens(
            file.number("rate", "Hz", 0.1, 120.0),
            file.count("width", 1, MAX_PIXELS),
            file.count("height", 1, MAX_PIXELS),
            file.number("view", "rad", 0.01, 3.0),
            file.number("sigma", "1", 0.0, 1.0));
    double farthest = file.positive("maxRange", "m", 10_000.0);
    Mount mount = Mount.pose(file);
    return new SensorKinds.Reader(
        vehicle ->
            new SimulatedCamera(
                lens,
                vehicle.streams(),
                () -> SimulatedCamera.ahead(vehicle.world(), vehicle.at(mount).get(), farthest)));
  }
}
