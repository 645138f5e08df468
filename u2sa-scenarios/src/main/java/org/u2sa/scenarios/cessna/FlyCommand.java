package org.u2sa.scenarios.cessna;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import java.util.function.Function;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.flightgear.protocol.ProtocolFiles;
import org.u2sa.mission.Mission;
import org.u2sa.report.score.RunPlan;
import org.u2sa.trials.run.Demo;
import org.u2sa.trials.run.DemoFrame;
import org.u2sa.trials.run.Simulation;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code u2sa fly --flightgear [host]}: flies the demo's mission in the real FlightGear. */
@Command(
    name = "fly",
    description = {
      "Fly the mission in FlightGear.",
      "",
      "Without a host, FlightGear is started here without a window and stopped after the flight "
          + "(scripts/flightgear/install installs it). With a host, start FlightGear there yourself, "
          + "after this command reports that it is listening; --protocol writes the two files that "
          + "FlightGear needs."
    })
final class FlyCommand implements Callable<Integer>, Demo {
  private static final String HERE = "127.0.0.1";

  @Mixin private DemoFrame frame;
  @Mixin private FlightGearPorts ports;
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
      description = "Do not start FlightGear; the user starts it on this machine.")
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
          "Time without readings from FlightGear after which to give up [s]. Default: 300 before "
              + "the flight, 60 in flight.")
  private Double waitS;

  @Override
  public Integer call() throws InterruptedException, IOException {
    if (protocol != null) {
      ProtocolFiles.writeTo(protocol);
      return ExitCode.DONE;
    }
    return frame.runInRealTime(this, patience());
  }

  @Override
  public Profile profile() {
    return CessnaDemo.flying("flightgear");
  }

  @Override
  public RunPlan.Start start(Mission mission) {
    return CessnaDemo.onRunway(mission);
  }

  @Override
  public Trial trial(Mission mission, Path directory, long seed) {
    Function<LaunchOptions, Simulation> flightGear =
        launch -> flightGear(launch, mission, directory);
    return new Trial(
        mission,
        FlightObserver::new,
        launch -> launch.override("Simulator", "MISSION", DemoFrame.absolute(mission)),
        flightGear, // supports real time only
        flightGear);
  }

  private Simulation flightGear(LaunchOptions launch, Mission mission, Path directory) {
    ports.configure(launch, host.isEmpty() ? HERE : host);
    return new FlightGearSimulation(
        ports,
        directory,
        mission,
        host.isEmpty() && !noStart ? Optional.empty() : Optional.of(frame.terminal()));
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
