package org.u2sa.scenarios.ugv;

import java.util.List;
import java.util.SplittableRandom;
import org.u2sa.device.port.LaserScanner;
import org.u2sa.drivers.ioio.BoardConnection;
import org.u2sa.drivers.ioio.LockstepConnection;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.MagneticModel;
import org.u2sa.messages.frame.Point;
import org.u2sa.report.score.RunPlan;
import org.u2sa.scenarios.run.LaserOnVehicle;
import org.u2sa.scenarios.run.SimulatedSensors;
import org.u2sa.sim.device.SimulatedLaser;
import org.u2sa.sim.ground.DifferentialParameters;
import org.u2sa.sim.ground.DriveCommand;
import org.u2sa.sim.ground.GroundStart;
import org.u2sa.sim.ground.GroundState;
import org.u2sa.sim.ground.Hazards;
import org.u2sa.sim.ground.MiniMolle;
import org.u2sa.sim.ioio.IoioBoard;
import org.u2sa.sim.ioio.IoioFirmware;
import org.u2sa.sim.ioio.IoioInProcess;
import org.u2sa.sim.sensor.CompassParameters;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.sensor.UbloxSettings;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.World;

/** The simulated world of one run: a vehicle with its sensors, wired to an IOIO board. */
final class UgvWorld {
  private static final int COMPASS_BAUD = 9600;
  private static final double YEAR = 2026.4;
  private static final double MAX_MISMATCH = 0.05;

  private static final double LASER_FORWARD_M = 0.2; // as in LidarSensor.xml
  private static final double LASER_UP_M = 0.4;
  private static final SimulatedLaser.Optics LASER =
      new SimulatedLaser.Optics(
          10.0, Math.toRadians(-135.0), Math.toRadians(0.5), 541, 0.06, 10.0, 0.03);

  private final World world;
  private final VehicleKind kind;
  private final MiniMolle vehicle;
  private final IoioFirmware board;
  private final IoioInProcess cable;

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
    this.kind = kind;
    Geodetic place = new Geodetic(start.longitudeDeg(), start.latitudeDeg(), start.altitudeM());
    world = World.at(place).with(conditions.terrain()).with(conditions.surface()).with(obstacles);
    double bySeed = new SplittableRandom(seed).nextDouble() * 2.0 * MAX_MISMATCH - MAX_MISMATCH;
    double mismatch = conditions.mismatch().orElse(bySeed);
    GroundStart at = new GroundStart(0.0, 0.0, start.headingRad());
    double declinationRad =
        MagneticModel.declinationRad(
            place.latitudeDeg(), place.longitudeDeg(), place.altitudeM(), YEAR);
    vehicle =
        MiniMolle.in(world)
            .vehicle(kind.make(at, mismatch, conditions.payloadKg()))
            .gps(receiver.parameters(), UbloxSettings.factory())
            .compass(CompassParameters.calibrated(declinationRad), COMPASS_BAUD)
            .hazards(hazards)
            .seed(seed)
            .build();
    board = new IoioFirmware(IoioBoard.OTG, vehicle);
    cable = new IoioInProcess(board);
  }

  /** Connects the board in-process, in lockstep. */
  BoardConnection connection() {
    return new LockstepConnection(
        cable::connect, cable::disconnect, cable::input, cable::output, cable::exchange);
  }

  /** The board, for other ways of serving it. */
  IoioFirmware board() {
    return board;
  }

  /** The cable, to simulate a disconnection. */
  IoioInProcess cable() {
    return cable;
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
  SimulatedSensors sensors(long seed) {
    SimulatedSensors sensors =
        new SimulatedSensors(
            seed, world.plane(), () -> new SimulatedSensors.Moment(vehicle.truth(), Point.ORIGIN));
    if (kind == VehicleKind.DIFFERENTIAL) {
      DifferentialParameters measures = DifferentialParameters.miniMolle();
      sensors.wheels(
          () -> vehicle.state().leftWheelRad(),
          () -> vehicle.state().rightWheelRad(),
          measures.wheelRadiusM(),
          measures.trackM());
    }
    return sensors;
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
