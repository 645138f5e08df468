package org.u2sa.scenarios.ugv;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.core.launch.VehicleMission;
import org.u2sa.core.mission.Home;
import org.u2sa.core.mission.Mission;
import org.u2sa.drivers.ioio.IoioService;
import org.u2sa.gcs.terminal.Terminal;
import org.u2sa.scenarios.report.RunReport;
import org.u2sa.scenarios.run.BrokerPort;
import org.u2sa.scenarios.run.DemoOptions;
import org.u2sa.scenarios.run.DemoRun;
import org.u2sa.scenarios.run.Interruption;
import org.u2sa.scenarios.run.Pace;
import org.u2sa.scenarios.run.PlannedSwap;
import org.u2sa.scenarios.run.RunChanges;
import org.u2sa.scenarios.run.RunLoop;
import org.u2sa.scenarios.run.Simulation;
import org.u2sa.sim.ground.Hazards;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code u2sa demo ugv}: laps of a loop of waypoints by the ground vehicle, through its board. */
@Command(
    name = "ugv",
    description = {
      "Drive a ground vehicle round a loop of waypoints, through its IOIO board.",
      "",
      "Starts the Communication Manager, the services of config/ugv/system.xml, and a simulated IOIO board with GPS, compass "
          + "and motors at its pins, and shows what happens. All noise follows from the seed.",
      "",
      "Other MQTT clients can listen meanwhile, for example:",
      "  mosquitto_sub -t 'u2sa/ugv/#' -F '%%t %%l bytes'"
    })
final class UgvDemo implements Callable<Integer> {
  private static final String NAME = "ugv";
  private static final int LAPS = 4;
  private static final Pace PACE = new Pace(60.0, 0.2);

  @Mixin private DemoOptions options;
  @Mixin private BrokerPort broker;
  @Mixin private RunChanges changes;
  @Mixin private ConditionOptions around;
  @Spec private CommandSpec command;

  @Option(
      names = "--vehicle",
      description = "One of ${COMPLETION-CANDIDATES}. Default: ${DEFAULT-VALUE}.")
  private VehicleKind vehicle = VehicleKind.DIFFERENTIAL;

  @Option(
      names = "--receiver",
      description = "Grade of the GPS: one of ${COMPLETION-CANDIDATES}. Default: ${DEFAULT-VALUE}.")
  private GpsGrade receiver = GpsGrade.SURVEY;

  @Option(
      names = "--control",
      description = "One of ${COMPLETION-CANDIDATES}. Default: ${DEFAULT-VALUE}.")
  private ControlKind control = ControlKind.PURSUIT;

  private Integer laps; // null: not given

  @Option(
      names = "--loops",
      paramLabel = "N",
      description = "How often round the waypoints. Default: 4; 1 with --mission.")
  private void loops(int value) {
    if (value < 1) {
      throw new ParameterException(
          command.commandLine(), "--loops " + value + ": expected 1 or more");
    }
    laps = value;
  }

  @Override
  public Integer call() throws InterruptedException, IOException {
    Path root = UgvFiles.root();
    SystemFile system = SystemFile.read(root.resolve("config/ugv").resolve(systemFile()));
    changes.check(system);
    LaunchOptions changed = new LaunchOptions();
    changes.applyTo(changed);
    Mission mission =
        VehicleMission.load(
            system, changed, options.mission().orElse(root.resolve("missions/ugv/loop.xml")));
    // what is wrong is said before anything is made
    DriveConditions conditions = around.conditions(vehicle, UgvFiles.plan(mission));
    List<PlannedSwap> planned = changes.swaps();
    return new RunLoop(options, command.commandLine().getOut())
        .run(
            NAME,
            (directory, seed, interruption) ->
                drive(system, mission, conditions, planned, directory, seed, interruption));
  }

  private String systemFile() {
    if (vehicle == VehicleKind.ACKERMANN) {
      if (control == ControlKind.PROPORTIONAL) {
        throw new ParameterException(
            command.commandLine(),
            "--control proportional: is for two driven wheels; expected pursuit with --vehicle ackermann");
      }
      return "system-ackermann.xml";
    }
    return control == ControlKind.PURSUIT ? "system.xml" : "system-proportional.xml";
  }

  private RunReport drive(
      SystemFile system,
      Mission mission,
      DriveConditions conditions,
      List<PlannedSwap> swaps,
      Path directory,
      long seed,
      Interruption interruption)
      throws InterruptedException {
    int wanted = laps != null ? laps : options.mission().isPresent() ? 1 : LAPS;
    Mission driven =
        Laps.write(mission, wanted, receiver.leastThresholdM(), directory.resolve("mission.xml"));
    Home home = UgvFiles.home(driven);
    UgvWorld world = new UgvWorld(home, vehicle, receiver, seed, Hazards.none(), conditions);
    DemoRun run =
        new DemoRun(
                NAME,
                system,
                UgvFiles.plan(driven),
                PACE,
                (context, plan, screen) -> new UgvObserver(context, plan, screen, world),
                directory,
                options.terminal(),
                interruption)
            .swapping(swaps);
    return drive(run, launch(system, driven), world, conditions.words(), seed);
  }

  private RunReport drive(
      DemoRun run, LaunchOptions launch, UgvWorld world, String words, long seed)
      throws InterruptedException {
    String simulator =
        vehicle.words()
            + " behind an IOIO, "
            + receiver.words()
            + ", "
            + control.name().toLowerCase(Locale.ROOT)
            + (words.isEmpty() ? "" : ", " + words);
    if (options.realtime()) {
      BoardServer server = new BoardServer(world, simulator);
      launch.override("IoioService", "CONNECTION", server.address());
      return run.inRealTime(launch, seed, server, OptionalDouble.empty());
    }
    launch.making(IoioService.class, context -> new IoioService(context, world.connection()));
    return run.inLockstep(launch, seed, Simulation.within(simulator, "vehicle"));
  }

  private LaunchOptions launch(SystemFile system, Mission mission) {
    Terminal terminal = options.terminal();
    LaunchOptions launch =
        new LaunchOptions()
            .console(line -> terminal.out().println(line))
            .override("MissionManager", "MISSION", absolute(mission.origin()))
            .override("PassThroughStateEstimator", "STALE AFTER", receiver.fixTimeoutS())
            .override("SafetyManager", "ARM AT START", true); // the demo is its own operator
    if (options.mission().isPresent()) {
      launch.override(
          "SafetyManager", "FENCE", ""); // another mission may be elsewhere on the earth
    }
    changes.applyTo(launch);
    broker.configure(system, launch, terminal);
    return launch;
  }

  /** A file as the user named it, so that it is found from any directory. */
  private static String absolute(String file) {
    return Path.of(file).toAbsolutePath().toString();
  }
}
