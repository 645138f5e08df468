package org.u2sa.scenarios.ugv;

import java.util.SplittableRandom;
import org.u2sa.core.mission.Home;
import org.u2sa.device.MagneticModel;
import org.u2sa.drivers.ioio.BoardConnection;
import org.u2sa.drivers.ioio.LockstepConnection;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.sim.ground.DriveCommand;
import org.u2sa.sim.ground.GroundStart;
import org.u2sa.sim.ground.GroundState;
import org.u2sa.sim.ground.Hazards;
import org.u2sa.sim.ground.MiniMolle;
import org.u2sa.sim.ground.Terrain;
import org.u2sa.sim.ioio.IoioBoard;
import org.u2sa.sim.ioio.IoioFirmware;
import org.u2sa.sim.ioio.IoioInProcess;
import org.u2sa.sim.sensor.CompassParameters;
import org.u2sa.sim.sensor.LocalPlane;
import org.u2sa.sim.sensor.UbloxSettings;

/**
 * The simulated world of one run: a vehicle with its sensors, and the IOIO board to which it is
 * wired.
 */
final class UgvWorld {
  private static final int COMPASS_BAUD = 9600;
  private static final double YEAR = 2026.4;
  private static final double MOST_MISMATCH = 0.05;

  private final LocalPlane plane;
  private final Terrain terrain;
  private final MiniMolle vehicle;
  private final IoioFirmware board;
  private final IoioInProcess cable;

  /**
   * @param home where the vehicle stands at first, on the earth
   * @param hazards what goes wrong
   */
  UgvWorld(Home home, VehicleKind kind, GpsGrade receiver, long seed, Hazards hazards) {
    this(home, kind, receiver, seed, hazards, DriveConditions.usual());
  }

  /**
   * @param conditions of vehicle and ground
   */
  UgvWorld(
      Home home,
      VehicleKind kind,
      GpsGrade receiver,
      long seed,
      Hazards hazards,
      DriveConditions conditions) {
    Geodetic place = home.geodetic().orElseThrow();
    plane = new LocalPlane(place);
    terrain = conditions.terrain();
    double bySeed = new SplittableRandom(seed).nextDouble() * 2.0 * MOST_MISMATCH - MOST_MISMATCH;
    double mismatch = conditions.mismatch().orElse(bySeed);
    GroundStart start = new GroundStart(0.0, 0.0, home.headingRad().orElse(0.0));
    double declinationRad =
        MagneticModel.declinationRad(
            place.latitudeDeg(), place.longitudeDeg(), place.altitudeM(), YEAR);
    vehicle =
        MiniMolle.on(plane)
            .vehicle(kind.make(start, mismatch, conditions.payloadKg()))
            .gps(receiver.parameters(), UbloxSettings.factory())
            .compass(CompassParameters.calibrated(declinationRad), COMPASS_BAUD)
            .surface(conditions.surface())
            .terrain(terrain)
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
  GroundState truth() {
    return vehicle.state();
  }

  /** What reaches the motors, from whoever drives. Safe from any thread. */
  DriveCommand motors() {
    return vehicle.command();
  }

  /** How steep the ground is there: rise over run [1]. */
  double rise(GroundState truth) {
    return Math.hypot(
        terrain.riseEast(truth.eastM(), truth.northM()),
        terrain.riseNorth(truth.eastM(), truth.northM()));
  }

  /** Where on the earth that is. */
  Geodetic place(GroundState truth) {
    return plane.at(truth.eastM(), truth.northM(), terrain.heightM(truth.eastM(), truth.northM()));
  }
}
