package org.u2sa.trials.run;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.drivers.ioio.IoioService;
import org.u2sa.drivers.ioio.LockstepConnection;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.mission.Mission;
import org.u2sa.report.score.RunPlan;
import org.u2sa.sim.file.VehicleDevices;
import org.u2sa.sim.file.VehicleFile;
import org.u2sa.sim.ground.Hazards;
import org.u2sa.sim.ground.MiniMolle;
import org.u2sa.sim.ioio.IoioBoard;
import org.u2sa.sim.ioio.IoioFirmware;
import org.u2sa.sim.ioio.IoioInProcess;
import org.u2sa.sim.ioio.IoioTcpServer;
import org.u2sa.sim.vehicle.RunningVehicle;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.vehicle.VehicleRun;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.World;
import org.u2sa.world.xml.WorldFile;

/**
 * The vehicle of a vehicle file in the world of one run, with its devices, and behind its IOIO
 * board if the system has an {@code IoioService}.
 */
public final class VehicleTrial {
  private final VehicleFile file;
  private final World world;
  private final RunningVehicle run;
  private final Optional<MiniMolle> pins;
  private final Optional<IoioInProcess> cable;
  private final Optional<IoioFirmware> board;
  private final VehicleDevices devices;

  private VehicleTrial(
      VehicleFile file, World world, RunningVehicle run, Optional<MiniMolle> pins, long seed) {
    this.file = file;
    this.world = world;
    this.run = run;
    this.pins = pins;
    board = pins.map(hardware -> new IoioFirmware(IoioBoard.OTG, hardware));
    cable = board.map(IoioInProcess::new);
    devices = new VehicleDevices(file, run, seed);
  }

  /**
   * Places a vehicle at rest.
   *
   * @param place east, north, up in the world [m]
   * @param headingRad clockwise from north [rad]
   */
  public static VehicleTrial of(
      VehicleFile file, World world, Point place, double headingRad, long seed) {
    RunningVehicle run = file.running(world, place, headingRad, seed);
    return new VehicleTrial(file, world, run, Optional.empty(), seed);
  }

  /**
   * Uses a file's vehicle that has already been placed.
   *
   * @param placed vehicle created from the file, or a wrapper of one
   */
  public static VehicleTrial of(VehicleFile file, SimulatedVehicle placed, long seed) {
    return new VehicleTrial(file, placed.world(), new VehicleRun(placed), Optional.empty(), seed);
  }

  /**
   * Places a vehicle behind its IOIO board.
   *
   * @param hazards faults to inject
   * @throws org.u2sa.interfaces.BadInputException if it has no board
   */
  public static VehicleTrial behindBoard(
      VehicleFile file, World world, Point place, double headingRad, Hazards hazards, long seed) {
    MiniMolle pins = file.board(world, place, headingRad, hazards, seed);
    return new VehicleTrial(file, world, pins, Optional.of(pins), seed);
  }

  /**
   * The world at a start, with everything in a world file.
   *
   * @param ground world without them, at the start
   * @param seed seed of gusts and waves
   */
  public static World around(World ground, Optional<Path> worldFile, long seed) {
    return worldFile
        .map(file -> SimulatedWorld.read(WorldFile.load(file), file, ground, seed))
        .orElse(ground);
  }

  /** An empty world whose origin is the start. */
  public static World at(RunPlan.Start start) {
    return World.at(new Geodetic(start.longitudeDeg(), start.latitudeDeg(), start.altitudeM()));
  }

  /** Latest ground truth of a vehicle behind a board. Thread-safe. */
  public VehicleTruth truth() {
    return board().truth();
  }

  /** The hardware at the board's pins. */
  public MiniMolle board() {
    return pins.orElseThrow();
  }

  /** Connection between board and services, to simulate a power failure. */
  public IoioInProcess cable() {
    return cable.orElseThrow();
  }

  public RunningVehicle run() {
    return run;
  }

  /** The world around the vehicle. */
  public World world() {
    return world;
  }

  public VehicleDevices devices() {
    return devices;
  }

  /**
   * Creates a run of the vehicle, armed at the start.
   *
   * @param simulator name in reports
   * @param scorer creates the scorer on the run's clock
   * @param settings further configuration
   */
  public Demo.Trial trial(
      Mission mission,
      String simulator,
      Function<Clock, TruthObserver.Scorer> scorer,
      Consumer<LaunchOptions> settings) {
    return new Demo.Trial(
        mission,
        TruthObserver.of(run, world.plane(), scorer),
        launch -> {
          launch.override("SafetyManager", "ARM AT START", true).devices(devices); // as operator
          settings.accept(launch);
        },
        launch -> inLockstep(launch, simulator),
        launch -> inRealTime(launch, simulator));
  }

  /** Connects the services to the board within this process, if there is one. */
  public Simulation inLockstep(LaunchOptions launch, String simulator) {
    cable.ifPresent(
        to ->
            launch.making(
                IoioService.class,
                context ->
                    new IoioService(
                        context,
                        new LockstepConnection(
                            to::connect, to::disconnect, to::input, to::output, to::exchange))));
    return new Simulation.Within(simulator, "vehicle");
  }

  /** Serves the board, if there is one, at an ephemeral TCP port of this machine. */
  private Simulation inRealTime(LaunchOptions launch, String simulator) {
    if (board.isEmpty()) {
      return new Simulation.Within(simulator, "vehicle");
    }
    IoioTcpServer server = new IoioTcpServer(board.get(), new SystemClock(), 0);
    launch.override("IoioService", "CONNECTION", "tcp:127.0.0.1:" + server.port());
    return new Simulation.Within(simulator, "vehicle").and(server::close);
  }

  public String name() {
    return file.name();
  }
}
