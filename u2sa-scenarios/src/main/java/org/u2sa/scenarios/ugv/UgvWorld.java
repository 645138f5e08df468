package org.u2sa.scenarios.ugv;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.device.port.LaserScanner;
import org.u2sa.drivers.ioio.BoardConnection;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.report.score.RunPlan;
import org.u2sa.scenarios.run.BoardCable;
import org.u2sa.scenarios.run.HomeFolder;
import org.u2sa.scenarios.run.LaserOnVehicle;
import org.u2sa.sim.device.SimulatedLaser;
import org.u2sa.sim.file.VehicleDevices;
import org.u2sa.sim.file.VehicleFile;
import org.u2sa.sim.ground.DriveCommand;
import org.u2sa.sim.ground.GroundState;
import org.u2sa.sim.ground.Hazards;
import org.u2sa.sim.ground.MiniMolle;
import org.u2sa.sim.ioio.IoioFirmware;
import org.u2sa.sim.ioio.IoioInProcess;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.World;

/** The simulated world of one run: a vehicle with its sensors, wired to an IOIO board. */
final class UgvWorld {
  private static final double LASER_FORWARD_M = 0.2; // as in LidarSensor.xml
  private static final double LASER_UP_M = 0.4;
  private static final SimulatedLaser.Optics LASER =
      new SimulatedLaser.Optics(
          10.0, Math.toRadians(-135.0), Math.toRadians(0.5), 541, 0.06, 10.0, 0.03);

  private final World world;
  private final VehicleFile file;
  private final MiniMolle vehicle;
  private final BoardCable cable;

  /**
   * @param start initial position of the vehicle
   * @param hazards faults to inject
   */
  UgvWorld(
      RunPlan.Start start,
      VehicleKind kind,
      GpsGrade receiver,
      long seed,
      Hazards hazards,
      DriveConditions conditions) {
    this(start, kind, receiver, seed, hazards, conditions, List.of());
  }

  /**
   * @param obstacles static obstacles
   */
  UgvWorld(
      RunPlan.Start start,
      VehicleKind kind,
      GpsGrade receiver,
      long seed,
      Hazards hazards,
      DriveConditions conditions,
      List<? extends ObjectDescription> obstacles) {
    Geodetic place = new Geodetic(start.longitudeDeg(), start.latitudeDeg(), start.altitudeM());
    world = World.at(place).with(conditions.terrain()).with(conditions.surface()).with(obstacles);
    Map<String, String> changes = new LinkedHashMap<>();
    changes.put("gps/@preset", receiver.preset());
    changes.put("ioio/gps/@preset", receiver.preset());
    conditions
        .mismatch()
        .ifPresent(share -> changes.put(kind.dynamics() + "/exactMismatch", "" + share));
    changes.put(kind.dynamics() + "/payload", "" + conditions.payloadKg());
    file =
        VehicleFile.load(
            HomeFolder.holding("config/ugv").resolve("config/ugv").resolve(kind.file()), changes);
    vehicle = file.board(world, Point.ORIGIN, start.headingRad(), hazards, seed);
    cable = new BoardCable(vehicle);
  }

  /** Name of the vehicle. */
  String name() {
    return file.name();
  }

  /** Connects the board in-process, in lockstep. */
  BoardConnection connection() {
    return cable.connection();
  }

  /** The board, for other ways of serving it. */
  IoioFirmware board() {
    return cable.board();
  }

  /** The cable, to simulate a disconnection. */
  IoioInProcess cable() {
    return cable.inProcess();
  }

  /** Latest ground truth. Thread-safe. */
  VehicleTruth truth() {
    return vehicle.truth();
  }

  /** Latest ground truth, including the rotating parts. */
  GroundState state() {
    return vehicle.state();
  }

  /** Devices for sensors that a system file adds to those on the board. */
  VehicleDevices devices(long seed) {
    return new VehicleDevices(file, vehicle, seed);
  }

  /** A lidar on the vehicle that sees the world's obstacles, with its own noise stream. */
  LaserScanner laser(long seed) {
    return new SimulatedLaser(
        LASER,
        new NoiseStreams(seed),
        new LaserOnVehicle(world, this::truth, LASER_FORWARD_M, LASER_UP_M, LASER.farthestM()));
  }

  /** Command at the motors, whatever its source. Thread-safe. */
  DriveCommand motors() {
    return vehicle.command();
  }

  /** Number of collisions. Thread-safe. */
  int contacts() {
    return vehicle.contacts().size();
  }

  /** The world around the vehicle. */
  World world() {
    return world;
  }
}
