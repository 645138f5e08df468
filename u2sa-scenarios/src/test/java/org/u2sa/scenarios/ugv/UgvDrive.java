package org.u2sa.scenarios.ugv;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.RunningSystem;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.device.LidarSensor;
import org.u2sa.device.port.LaserScanner;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.mission.Mission;
import org.u2sa.report.score.RunPlan;
import org.u2sa.service.ServiceContext;
import org.u2sa.sim.file.VehicleFile;
import org.u2sa.sim.ground.DriveCommand;
import org.u2sa.sim.ground.GroundState;
import org.u2sa.sim.ground.Hazards;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.testkit.Repository;
import org.u2sa.trials.run.RunPlans;
import org.u2sa.trials.run.TruthObserver;
import org.u2sa.trials.run.VehicleTrial;

/**
 * A drive of the configured ground vehicle in lockstep, in which a scenario makes things go wrong.
 */
final class UgvDrive implements AutoCloseable {
  private static final double LOOK_S = 0.01;
  private static final double STOOD_S = 0.5; // braked wheels rock back by millimetres

  private final LockstepClock clock = new LockstepClock();
  private final RunningSystem running;
  private final Mission mission;
  private final List<Double> misses = new ArrayList<>();
  final VehicleTrial vehicle;
  final Walkers walkers = new Walkers(); // whom the laser sees besides the obstacles
  final TestOperator operator;

  /** One loop by {@code config/ugv/system.xml}. */
  UgvDrive(Path logs, Hazards hazards, boolean armAtStart) {
    this(logs, config().resolve("system.xml"), 1, hazards, armAtStart);
  }

  /** One loop by another system file. */
  UgvDrive(Path logs, Path system, long seed, Hazards hazards, boolean armAtStart) {
    this(logs, system, new Scene(seed, GpsGrade.SURVEY, hazards, List.of()), armAtStart, o -> {});
  }

  /**
   * What is there besides the vehicle.
   *
   * @param obstacles that a laser sees, if the system file has one
   */
  record Scene(
      long seed, GpsGrade receiver, Hazards hazards, List<? extends ObjectDescription> obstacles) {}

  /**
   * One loop.
   *
   * @param more changes what is launched
   */
  UgvDrive(Path logs, Path system, Scene scene, boolean armAtStart, Consumer<LaunchOptions> more) {
    System.setProperty("u2sa.home", Repository.root().toString());
    long seed = scene.seed();
    mission = Mission.load(Repository.root().resolve("missions/ugv/loop.xml"));
    vehicle = vehicle(mission, scene);
    LaunchOptions options =
        new LaunchOptions()
            .clock(clock)
            .seed(seed)
            .logDirectory(logs)
            .override("CommunicationManager", "BROKER", "none")
            .override("SafetyManager", "ARM AT START", armAtStart)
            .making(
                LidarSensor.class,
                context -> new LidarSensor(context, walkers.seenBy(laser(context), vehicle::truth)))
            .devices(vehicle.devices());
    vehicle.inLockstep(options, "");
    more.accept(options);
    running = RunningSystem.start(SystemFile.read(system), options);
    operator =
        new TestOperator(running.contextFor(XmlConfiguration.inMemory("TestOperator", Map.of())));
    operator.start();
  }

  /** The vehicle of a scene at the home of a mission, behind its board. */
  static VehicleTrial vehicle(Mission mission, Scene scene) {
    RunPlan.Start start = RunPlans.start(mission);
    Map<String, String> grade = new LinkedHashMap<>();
    grade.put("gps/@preset", scene.receiver().preset());
    grade.put("ioio/gps/@preset", scene.receiver().preset());
    VehicleTrial placed =
        VehicleTrial.behindBoard(
            VehicleFile.load(config().resolve("vehicle.xml"), grade),
            VehicleTrial.at(start).with(scene.obstacles()),
            Point.ORIGIN,
            start.headingRad(),
            scene.hazards(),
            scene.seed());
    placed.devices().noise("LidarSensor", new NoiseStreams(scene.seed()));
    return placed;
  }

  /** The vehicle's laser. */
  LaserScanner laser(ServiceContext context) {
    return vehicle
        .devices()
        .device(LaserScanner.class, "LidarSensor", context.configuration(), context.clock())
        .orElseThrow();
  }

  /** The true state, with the rotating parts. */
  GroundState state() {
    return vehicle.board().state();
  }

  /** How often the vehicle has touched something. */
  int contacts() {
    return vehicle.board().contacts().size();
  }

  /** Where the vehicle's files are. */
  static Path config() {
    return Repository.root().resolve("config/ugv");
  }

  /** Ends a service as if its process were gone: nobody restarts it. */
  void kill(String service) {
    running.services().stream()
        .filter(each -> each.getServiceName().equals(service))
        .findFirst()
        .orElseThrow(() -> new AssertionError("no service " + service))
        .kill();
  }

  /** How far the vehicle truly was from each waypoint when it took it for reached [m]. */
  List<Double> misses() {
    return misses;
  }

  private void noteMisses() {
    while (misses.size() < Math.min(operator.goalsDone(), mission.goals().size())) {
      Waypoint reached = (Waypoint) mission.goals().get(misses.size());
      VehicleTruth truth = vehicle.truth();
      Geodetic here = vehicle.world().plane().at(truth.position().x(), truth.position().y(), 0.0);
      Point to =
          here.enuOf(new Geodetic(reached.x().getAsDouble(), reached.y().getAsDouble(), 0.0));
      misses.add(Math.hypot(to.x(), to.y()));
    }
  }

  double nowS() {
    return Clock.seconds(clock.micros());
  }

  void drive(double seconds) throws InterruptedException {
    clock.advance(Clock.micros(seconds));
    noteMisses();
    walkers.look(vehicle.truth());
  }

  /** Fails if it does not come to that. */
  void driveUntil(String what, BooleanSupplier condition, double atMostS)
      throws InterruptedException {
    double end = nowS() + atMostS;
    while (!condition.getAsBoolean()) {
      if (nowS() > end) {
        throw new AssertionError(
            "not within "
                + atMostS
                + " s: "
                + what
                + "; "
                + operator.action()
                + " "
                + operator.causes()
                + ", "
                + state());
      }
      drive(LOOK_S);
    }
  }

  /** Until it is on its way to the first waypoint at full speed. */
  void driveAtFullSpeed() throws InterruptedException {
    driveUntil("drives", () -> state().forwardMps() > 0.95, 20.0);
  }

  private boolean moves() {
    return TruthObserver.moves(vehicle.truth());
  }

  /** Whether neither motor is driven. */
  boolean motorsOff() {
    DriveCommand motors = vehicle.board().command();
    return !drives(motors.first()) && !drives(motors.second());
  }

  private static boolean drives(double command) {
    return Math.abs(command) > 0.005; // NaN: no pulses at all
  }

  /** How a vehicle came to rest. */
  record Stop(double motorsOffS, double standsS, double wayM) {}

  /** Measures from now on how long it takes and how far it gets until it stands. */
  Stop stop(double atMostS) throws InterruptedException {
    double from = nowS();
    GroundState began = state();
    driveUntil("motors off", this::motorsOff, atMostS);
    double motorsOffS = nowS() - from;
    double movedS = nowS();
    while (nowS() - movedS < STOOD_S) {
      drive(LOOK_S);
      movedS = moves() ? nowS() : movedS;
      if (movedS - from > atMostS) {
        throw new AssertionError("does not stand after " + atMostS + " s: " + state());
      }
    }
    GroundState ended = state();
    return new Stop(
        motorsOffS,
        movedS - from,
        Math.hypot(ended.eastM() - began.eastM(), ended.northM() - began.northM()));
  }

  /** Fails if it moves in that time. */
  void requireStanding(double forS) throws InterruptedException {
    GroundState began = state();
    for (double end = nowS() + forS; nowS() < end; ) {
      drive(LOOK_S);
      if (moves() || !motorsOff()) {
        throw new AssertionError(
            "moved at " + nowS() + " s: " + state() + ", " + vehicle.board().command());
      }
    }
    double way = Math.hypot(state().eastM() - began.eastM(), state().northM() - began.northM());
    if (way > 0.02) {
      throw new AssertionError("crept " + way + " m in " + forS + " s");
    }
  }

  @Override
  public void close() {
    operator.kill();
    running.close();
  }
}
