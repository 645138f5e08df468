package org.u2sa.scenarios.roboboat.subvehicle;

import java.nio.file.Path;
import java.util.Optional;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.RunningSystem;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.device.payload.LoadCell;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.device.SensorErrors;
import org.u2sa.sim.device.SimulatedLoadCell;
import org.u2sa.sim.file.VehicleFile;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.RunningVehicle;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.World;
import org.u2sa.trials.run.VehicleTrial;

/**
 * The simulated quadrotor on a boat's deck; its own services start when it is switched on. Its
 * world is a level plane at the deck's height, with the boat's wind.
 */
public final class QuadrotorOnDeck implements AutoCloseable {
  /** Height of the boat's deck and of the dock above the water [m]. */
  public static final double DECK_M = 0.4;

  /** A load cell of 5 N with an HX711 converter, tared before take-off. */
  private static final SensorErrors CELL = new SensorErrors(10.0, 0.05, 0.1, 0.1, 0.0);

  private final Path folder;
  private final RunningVehicle boat;
  private final PuckGripper gripper;
  private final Path logs;
  private final long seed;
  private volatile RunningVehicle flown; // null until it is switched on
  private RunningSystem system; // likewise

  /**
   * @param folder folder of its system file and vehicle file
   * @param boat boat, moored by the time the quadrotor is switched on
   * @param puck position of the puck on the dock: east, north [m]
   */
  public QuadrotorOnDeck(Path folder, RunningVehicle boat, Point puck, Path logs, long seed) {
    this.folder = folder;
    this.boat = boat;
    gripper = new PuckGripper(puck);
    this.logs = logs;
    this.seed = seed;
  }

  public PuckGripper gripper() {
    return gripper;
  }

  /** The vehicle, once it is switched on. */
  public Optional<RunningVehicle> flown() {
    return Optional.ofNullable(flown);
  }

  /** Starts it on the deck, and returns the link to its services. */
  public Transport switchOn(Clock clock) {
    VehicleTruth at = boat.at(clock.micros());
    World water = boat.vehicle().world();
    Geodetic origin = water.plane().origin();
    World deck =
        World.at(new Geodetic(origin.longitudeDeg(), origin.latitudeDeg(), DECK_M))
            .with(water.wind());
    VehicleTrial trial =
        VehicleTrial.of(
            VehicleFile.load(folder.resolve("vehicle.xml")),
            deck,
            Point.of(at.position().x(), at.position().y(), 0.0),
            at.headingRad(),
            seed);
    flown = trial.run();
    system =
        RunningSystem.start(
            SystemFile.read(folder.resolve("aboard.xml")),
            new LaunchOptions()
                .clock(clock)
                .seed(seed)
                .logDirectory(logs)
                .override("CommunicationManager", "BROKER", "none")
                .devices(trial.devices().with(LoadCell.class, unused -> cell())));
    return system.communicationManager().transport();
  }

  private LoadCell cell() {
    return new SimulatedLoadCell(CELL, new NoiseStreams(seed), gripper::loadN);
  }

  @Override
  public void close() {
    if (system != null) {
      system.close();
    }
  }
}
