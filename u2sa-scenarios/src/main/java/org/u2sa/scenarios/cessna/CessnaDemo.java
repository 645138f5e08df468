package org.u2sa.scenarios.cessna;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.core.launch.VehicleMission;
import org.u2sa.core.mission.Mission;
import org.u2sa.flightgear.link.EmbeddedStart;
import org.u2sa.gcs.terminal.Terminal;
import org.u2sa.scenarios.report.RunReport;
import org.u2sa.scenarios.run.BrokerPort;
import org.u2sa.scenarios.run.DemoOptions;
import org.u2sa.scenarios.run.DemoRun;
import org.u2sa.scenarios.run.PlannedSwap;
import org.u2sa.scenarios.run.RunChanges;
import org.u2sa.scenarios.run.RunLoop;
import org.u2sa.scenarios.run.Simulation;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code u2sa demo cessna}: take-off and ten waypoints in the embedded simulator. */
@Command(
    name = "cessna",
    description = {
      "Fly a Cessna 172 over ten waypoints, take-off included.",
      "",
      "Starts the Communication Manager, the services of config/cessna/system.xml and the embedded simulator, and shows what "
          + "happens. Wind and gusts follow from the seed. Control flies on the simulator's truth: no sensor is noisy.",
      "",
      "Other MQTT clients can listen meanwhile, for example:",
      "  mosquitto_sub -t 'u2sa/cessna/#' -F '%%t %%l bytes'"
    })
final class CessnaDemo implements Callable<Integer> {
  @Mixin private DemoOptions options;
  @Mixin private BrokerPort broker;
  @Mixin private RunChanges changes;
  @Spec private CommandSpec command;

  @Option(
      names = "--wind",
      paramLabel = "WIND",
      description =
          "calm, or m/s@degrees it blows from, such as 5@270. Default: by the seed, up to 8 m/s.")
  private String wind;

  @Option(
      names = "--shear",
      description =
          "Wind grows with height: --wind is 6 m above ground, 1.8 times as much blows at 300 m. Default: alike at every height.")
  private boolean shear;

  @Override
  public Integer call() throws InterruptedException, IOException {
    Path home = CessnaFiles.root();
    Path missionFile = options.mission().orElse(home.resolve("missions/cessna/mission.xml"));
    SystemFile system = SystemFile.read(home.resolve("config/cessna/system.xml"));
    changes.check(system);
    LaunchOptions changed = new LaunchOptions();
    changes.applyTo(changed);
    Mission mission = VehicleMission.load(system, changed, missionFile);
    EmbeddedStart.of(mission); // what is wrong is said before anything is made
    windOf(options.seed());
    List<PlannedSwap> planned = changes.swaps();
    return new RunLoop(options, command.commandLine().getOut())
        .run(
            "cessna",
            (directory, seed, interruption) ->
                fly(
                    new DemoRun(
                            "cessna",
                            system,
                            CessnaFiles.plan(mission),
                            CessnaFiles.PACE,
                            FlightObserver::new,
                            directory,
                            options.terminal(),
                            interruption)
                        .swapping(planned),
                    system,
                    mission,
                    seed));
  }

  private RunReport fly(DemoRun run, SystemFile system, Mission mission, long seed)
      throws InterruptedException {
    Terminal terminal = options.terminal();
    DemoWind demoWind = windOf(seed);
    terminal
        .out()
        .printf(
            Locale.ROOT,
            "Seed %d, wind %.1f m/s from %.0f degrees%s%n",
            seed,
            demoWind.speedMps(),
            Math.toDegrees(demoWind.fromRad()),
            shear ? " near the ground, more above" : "");
    LaunchOptions launch = new LaunchOptions().console(line -> terminal.out().println(line));
    CessnaFiles.fly(launch, mission, options.mission().isEmpty());
    demoWind.applyTo(launch);
    changes.applyTo(launch);
    broker.configure(system, launch, terminal);
    if (options.realtime()) {
      StandInSimulation standIn = new StandInSimulation(mission, demoWind.wind(seed));
      standIn.configure(launch);
      return run.inRealTime(launch, seed, standIn, OptionalDouble.empty());
    }
    launch.override("Simulator", "LINK", "embedded");
    return run.inLockstep(launch, seed, Simulation.within("embedded Cessna 172", "aircraft"));
  }

  private DemoWind windOf(long seed) {
    if (wind == null) {
      return DemoWind.ofSeed(seed).withShear(shear);
    }
    try {
      return DemoWind.parse(wind).withShear(shear);
    } catch (IllegalArgumentException e) {
      throw new ParameterException(command.commandLine(), "--wind: " + e.getMessage());
    }
  }
}
