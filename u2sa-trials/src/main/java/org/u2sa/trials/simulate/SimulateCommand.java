package org.u2sa.trials.simulate;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.drivers.ioio.IoioService;
import org.u2sa.estimation.FusingStateEstimator;
import org.u2sa.estimation.StatedPlacement;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.disk.RegularFile;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.mission.Home;
import org.u2sa.mission.Mission;
import org.u2sa.mission.MissionManager;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.Surroundings;
import org.u2sa.sim.file.VehicleFile;
import org.u2sa.sim.ground.Hazards;
import org.u2sa.sim.world.LocalPlane;
import org.u2sa.sim.world.World;
import org.u2sa.trials.run.Demo;
import org.u2sa.trials.run.DemoFrame;
import org.u2sa.trials.run.RunPlans;
import org.u2sa.trials.run.SimulatedWorld;
import org.u2sa.trials.run.VehicleFileChanges;
import org.u2sa.trials.run.VehicleTrial;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code u2sa simulate}: runs an unchanged system file with a vehicle from a vehicle file. */
@Command(
    name = "simulate",
    description = {
      "Run a system file with a simulated vehicle of your own, from a vehicle file.",
      "",
      "The services are those of the system file, unchanged; their devices are the vehicle's (docs/vehicle-files.md). The vehicle starts at "
          + "the mission's home. The command acts as operator and arms the vehicle."
    })
final class SimulateCommand implements Callable<Integer>, Demo {
  private static final double READY_WITHIN_S = 120.0;
  private static final double SLOWEST_MPS = 0.1;
  private static final double OTHER_GOAL_S = 300.0;

  @Mixin private DemoFrame frame;
  @Spec private CommandSpec command;

  @Parameters(paramLabel = "SYSTEM.xml", description = "System file.")
  private Path systemFile;

  @Option(
      names = "--vehicle",
      paramLabel = "FILE",
      required = true,
      description = "Vehicle file (XML).")
  private Path vehicleFile;

  @Mixin private VehicleFileChanges changes;

  @Option(
      names = "--world",
      paramLabel = "FILE",
      description = "World XML file with the vehicle's surroundings. Default: empty.")
  private Path worldFile; // null for an empty world

  @Option(
      names = "--start",
      paramLabel = "LONGITUDE,LATITUDE[,HEADING]",
      split = ",",
      description =
          "Where the vehicle starts, at the altitude of the mission's home, and the origin of local frames [deg]. Default: the home.")
  private double[] start; // null for the mission's home

  @Option(
      names = "--limit",
      paramLabel = "SECONDS",
      description =
          "Simulated time after which the run ends. Default: depends on the length of the mission.")
  private Double limitS; // null if not given

  private VehicleFile vehicle;
  private LaunchOptions options; // of the present run
  private int unplaced;
  private RunPlan.Start placed; // of the newest plan
  private double longestS; // of the newest plan

  @Override
  public Integer call() throws InterruptedException, IOException {
    RegularFile.require(systemFile, "a system file (XML)");
    if (limitS != null && !(limitS > 0.0 && Double.isFinite(limitS))) {
      throw wrong("--limit " + limitS + ": expected more than 0 s");
    }
    if (start != null
        && (start.length < 2
            || start.length > 3
            || !(Math.abs(start[0]) <= 180.0 && Math.abs(start[1]) <= 85.0))) {
      throw wrong(
          "--start: expected LONGITUDE,LATITUDE[,HEADING] in degrees, at most 85 degrees north or south");
    }
    vehicle = changes.load(vehicleFile);
    return frame.run(this);
  }

  private ParameterException wrong(String message) {
    return new ParameterException(command.commandLine(), message);
  }

  @Override
  public Profile profile() {
    return new Profile(
        "simulate",
        "simulate",
        "",
        switch (vehicle.model().medium()) {
          case GROUND -> Domain.GROUND;
          case WATER -> Domain.WATER;
          case AIR -> Domain.SMALL_AIRCRAFT;
        },
        READY_WITHIN_S,
        SLOWEST_MPS);
  }

  @Override
  public Path system() {
    return systemFile;
  }

  /** {@inheritDoc} Defaults to the mission named by the Mission Manager's configuration. */
  @Override
  public Path ownMission(SystemFile system, LaunchOptions options) {
    for (SystemFile.Entry entry : system.services()) {
      if (entry.className().equals(MissionManager.class.getName())) {
        return options.configuration(entry).namedFile("MISSION");
      }
    }
    throw new BadInputException(
        system.file() + ": lists no MissionManager; expected one, and its mission");
  }

  @Override
  public boolean isConfiguredForMission() {
    return true;
  }

  @Override
  public Optional<Path> world() {
    return Optional.ofNullable(worldFile);
  }

  @Override
  public Surroundings surroundings() {
    return worldFile == null
        ? Surroundings.none()
        : SimulatedWorld.surroundings(world(placed, 0L), longestS);
  }

  @Override
  public RunPlan.Start start(Mission mission) {
    Optional<Home> home = mission.home();
    Optional<Geodetic> onEarth = home.flatMap(Home::geodetic);
    if (start != null) {
      return new RunPlan.Start(
          start[0],
          start[1],
          onEarth.map(Geodetic::altitudeM).orElse(0.0),
          Math.toRadians(start.length > 2 ? start[2] : 0.0));
    }
    if (onEarth.isPresent()) {
      return RunPlans.start(mission);
    }
    boolean isLocal =
        mission.goals().stream()
            .noneMatch(goal -> goal instanceof Waypoint at && at.referenceFrame().isEarth());
    if (!isLocal) {
      throw new BadInputException(
          mission.origin() + ": has no home on the earth; expected <home>, or --start");
    }
    return new RunPlan.Start(
        0.0, 0.0, 0.0, home.map(at -> at.headingRad().orElse(0.0)).orElse(0.0));
  }

  @Override
  public RunPlan plan(Mission mission) {
    RunPlan.Start at = start(mission);
    placed = at;
    LocalPlane plane = world(at, 0L).plane();
    Geodetic from = plane.origin().fromEnu(place(mission));
    RunPlan.Start there =
        new RunPlan.Start(from.longitudeDeg(), from.latitudeDeg(), at.altitudeM(), at.headingRad());
    RunPlan plan = RunPlans.placed(profile().domain(), mission, there, plane);
    unplaced = mission.goals().size() - plan.waypoints().size();
    longestS = limitS(plan);
    return plan;
  }

  @Override
  public double limitS(RunPlan plan) {
    return limitS != null ? limitS : Demo.super.limitS(plan) + unplaced * OTHER_GOAL_S;
  }

  /**
   * East and north of a home in local axes, from their origin [m]; else the vehicle starts there.
   */
  private Point place(Mission mission) {
    Optional<Home> local =
        mission.home().filter(home -> start == null && home.referenceFrame().isLocal());
    return local
        .map(
            home ->
                home.referenceFrame().equals(ReferenceFrame.LOCAL_ENU)
                    ? Point.of(home.x(), home.y(), 0.0)
                    : Point.of(home.y(), home.x(), 0.0))
        .orElse(Point.ORIGIN);
  }

  /** The world of a run, with the environment of its file. */
  private World world(RunPlan.Start at, long seed) {
    return vehicle.home(VehicleTrial.around(VehicleTrial.at(at), world(), seed));
  }

  @Override
  public Trial trial(Mission mission, Path directory, long seed) {
    RunPlan.Start at = start(mission);
    World world = world(at, seed);
    VehicleTrial placed =
        hasService(IoioService.class)
            ? VehicleTrial.behindBoard(
                vehicle, world, place(mission), at.headingRad(), Hazards.none(), seed)
            : VehicleTrial.of(vehicle, world, place(mission), at.headingRad(), seed);
    Set<String> goals = new LinkedHashSet<>();
    mission.goals().forEach(goal -> goals.add(goal.uid()));
    int elsewhere = goals.size() - plan(mission).waypoints().size();
    Geodetic from = world.plane().origin().fromEnu(place(mission));
    return placed.trial(
        mission,
        vehicle.name(),
        clock -> {
          tellMisplaced(placed, from);
          return new EstimateScorer(placed.run(), world.plane().origin(), clock, goals, elsewhere);
        },
        launch -> options = launch);
  }

  /** Says where the State Estimator's configuration does not fit the vehicle. */
  private void tellMisplaced(VehicleTrial placed, Geodetic start) {
    SystemFile.read(systemFile).services().stream()
        .filter(entry -> entry.className().equals(FusingStateEstimator.class.getName()))
        .map(entry -> new StatedPlacement(options.configuration(entry)))
        .flatMap(stated -> stated.differences(placed.devices().mounted(), start).stream())
        .forEach(frame.terminal().out()::println);
  }

  private boolean hasService(Class<?> service) {
    return SystemFile.read(systemFile).services().stream()
        .anyMatch(entry -> entry.className().equals(service.getName()));
  }
}
