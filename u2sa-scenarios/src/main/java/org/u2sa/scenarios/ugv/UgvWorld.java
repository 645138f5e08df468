package org.u2sa.scenarios.ugv;

import java.util.List;
import java.util.SplittableRandom;
import org.u2sa.device.LaserScanner;
import org.u2sa.device.MagneticModel;
import org.u2sa.drivers.ioio.BoardConnection;
import org.u2sa.drivers.ioio.LockstepConnection;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.scenarios.report.RunPlan;
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

/**
 * The simulated world of one run: a vehicle with its sensors, and the IOIO board to which it is
 * wired.
 */
final class UgvWorld {
  private static final int COMPASS_BAUD = 9600;
  private static final double YEAR = 2026.4;
  private static final double MOST_MISMATCH = 0.05;

  private static final double LASER_FORWARD_M = 0.2; // as LidarSensor.xml says
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
   * @param start where the vehicle stands at first
   * @param hazards what goes wrong
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
   * @param obstacles that stand around
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
    double bySeed = new SplittableRandom(seed).nextDouble() * 2.0 * MOST_MISMATCH - MOST_MISMATCH;
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

  /** The board on a cable within this process, in lockstep. */
  BoardConnection connection() {
    return new LockstepConnection(
        cable::connect, cable::disconnect, cable::input, cable::output, cable::exchange);
  }

  /** The board, for whoever serves it otherwise. */
  IoioFirmware board() {
    return board;
  }

  /** The cable, for pulling it. */
  IoioInProcess cable() {
    return cable;
  }

  /** The truth of the last moment. Safe from any thread. */
  VehicleTruth truth() {
    return vehicle.truth();
  }

  /** The same with all that turns in the vehicle. */
  GroundState state() {
    return vehicle.state();
  }

  /** Devices for the sensors that a system file adds to those at the board. */
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

  /** A laser on the vehicle that sees the world's obstacles, with noise of its own. */
  LaserScanner laser(long seed) {
    return new SimulatedLaser(
        LASER,
        new NoiseStreams(seed),
        new LaserOnVehicle(world, this::truth, LASER_FORWARD_M, LASER_UP_M, LASER.farthestM()));
  }

  /** What reaches the motors, from whoever drives. Safe from any thread. */
  DriveCommand motors() {
    return vehicle.command();
  }

  /** How often it ran into something. Safe from any thread. */
  int contacts() {
    return vehicle.contacts().size();
  }

  /** What it stands in. */
  World world() {
    return world;
  }
}
