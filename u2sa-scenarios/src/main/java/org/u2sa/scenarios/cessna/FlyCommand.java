package org.u2sa.scenarios.cessna;

import java.io.IOException;
import java.nio.file.Path;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.core.launch.VehicleMission;
import org.u2sa.core.mission.Mission;
import org.u2sa.flightgear.link.EmbeddedStart;
import org.u2sa.flightgear.protocol.ProtocolFiles;
import org.u2sa.gcs.command.ExitCode;
import org.u2sa.gcs.terminal.Terminal;
import org.u2sa.scenarios.report.RunReport;
import org.u2sa.scenarios.run.BrokerPort;
import org.u2sa.scenarios.run.DemoOptions;
import org.u2sa.scenarios.run.DemoRun;
import org.u2sa.scenarios.run.RunLoop;
import org.u2sa.scenarios.run.Simulation;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code u2sa fly --flightgear [host]}: the demo's mission in the real FlightGear. */
@Command(
    name = "fly",
    description = {
      "Fly the mission in FlightGear.",
      "",
      "Without a host, FlightGear is started here without a window and stopped after the flight (scripts/flightgear/install "
          + "gets it). With a host, start FlightGear there yourself, after this command says that it listens; --protocol "
          + "writes the two files that it needs."
    })
final class FlyCommand implements Callable<Integer> {
  private static final String HERE = "127.0.0.1";

  @Mixin private DemoOptions options;
  @Mixin private FlightGearPorts ports;
  @Mixin private BrokerPort broker;
  @Spec private CommandSpec command;

  @Option(
      names = "--flightgear",
      arity = "0..1",
      fallbackValue = "",
      paramLabel = "HOST",
      required = true,
      description = "Fly in FlightGear, started here, or running on HOST.")
  private String host;

  @Option(
      names = "--no-start",
      description = "Do not start FlightGear: it is started by hand on this machine.")
  private boolean noStart;

  @Option(
      names = "--protocol",
      paramLabel = "DIR",
      description =
          "Only write FlightGear's two protocol files to DIR/Protocol (for its option --data=DIR).")
  private Path protocol;

  @Option(
      names = "--wait",
      paramLabel = "SECONDS",
      description =
          "Give up when nothing was heard of FlightGear for so long. Default: 300 before the flight, 60 in flight.")
  private Double waitS;

  @Override
  public Integer call() throws InterruptedException, IOException {
    if (protocol != null) {
      ProtocolFiles.writeTo(protocol);
      return ExitCode.DONE;
    }
    Path root = CessnaFiles.root();
    SystemFile system = SystemFile.read(root.resolve("config/cessna/system.xml"));
    Mission mission =
        VehicleMission.load(
            system,
            new LaunchOptions(),
            options.mission().orElse(root.resolve("missions/cessna/mission.xml")));
    EmbeddedStart.of(mission); // what is wrong is said before anything is made
    patience();
    return new RunLoop(options, command.commandLine().getOut())
        .run(
            "flightgear",
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
                        interruption),
                    root,
                    system,
                    mission,
                    directory,
                    seed));
  }

  private RunReport fly(
      DemoRun run, Path root, SystemFile system, Mission mission, Path directory, long seed)
      throws InterruptedException {
    Terminal terminal = options.terminal();
    LaunchOptions launch = new LaunchOptions().console(line -> terminal.out().println(line));
    CessnaFiles.fly(launch, mission, options.mission().isEmpty());
    boolean elsewhere = !host.isEmpty();
    broker.configure(system, launch, terminal);
    ports.configure(launch, elsewhere ? host : HERE);
    Simulation simulation =
        elsewhere || noStart
            ? new AwaitedFlightGear(terminal, ports)
            : new FlightGearSimulation(root, directory, mission, ports);
    return run.inRealTime(launch, seed, simulation, patience());
  }

  private OptionalDouble patience() {
    if (waitS == null) {
      return OptionalDouble.empty();
    }
    if (!(waitS > 0.0)) {
      throw new ParameterException(
          command.commandLine(), "--wait " + waitS + ": expected more than 0 seconds");
    }
    return OptionalDouble.of(waitS);
  }
}
