package org.u2sa.cli.describe;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.cli.terminal.Terminal;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.interfaces.RunFailedException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code u2sa describe}: shows a vehicle's composition and autonomy. */
@Command(
    name = "describe",
    description = {
      "Describe a vehicle: levels of autonomy and what justifies them, services, channels, sources, actuators.",
      "",
      "By its system file without starting it, or with --connect as it runs; with both, the levels that the file states "
          + "beside what runs."
    })
public final class DescribeCommand implements Callable<Integer> {
  @Spec private CommandSpec command;
  @Mixin private RemoteSystem remote;

  @Parameters(
      arity = "0..1",
      paramLabel = "SYSTEM FILE",
      description = "The vehicle's system file.")
  private Path file;

  @Option(names = "--connect", description = "Ask the vehicle that runs at --broker.")
  private boolean connect;

  @Option(names = "--variables", description = "Print the variables that configuration files set.")
  private boolean variables;

  @Option(names = "--json", description = "Print JSON.")
  private boolean json;

  @Override
  public Integer call() throws InterruptedException {
    if (file == null && !connect) {
      throw new ParameterException(
          command.commandLine(), "describes nothing: expected a system file, --connect, or both");
    }
    Optional<SystemFile> system = Optional.ofNullable(file).map(SystemFile::read);
    return connect ? running(system) : planned(system.orElseThrow());
  }

  private int planned(SystemFile system) {
    try {
      print(CompositionOfFile.of(system));
    } catch (IOException e) {
      throw new RunFailedException("the services could not be made: " + e.getMessage(), e);
    }
    return ExitCode.DONE;
  }

  private int running(Optional<SystemFile> system) throws InterruptedException {
    try (RemoteLink link = remote.connect()) {
      VehicleComposition vehicle =
          CompositionOfRunning.of(
              link, remote.brokerAddress(), system.flatMap(SystemFile::autonomy));
      if (vehicle.services().isEmpty()) {
        throw new RunFailedException(
            link.systemId()
                + ": no service answered within "
                + link.timeoutS()
                + " s"
                + remote.otherSystems(link).map(others -> ";" + others.substring(1)).orElse(""));
      }
      print(vehicle);
    }
    return ExitCode.DONE;
  }

  private void print(VehicleComposition vehicle) {
    PrintWriter out = command.commandLine().getOut();
    if (json) {
      out.print(DescriptionJson.text(vehicle)); // contains its own line breaks
      out.println();
    } else {
      Terminal terminal = Terminal.detect(out, System.getenv());
      new DescriptionText(vehicle, terminal, variables).lines().forEach(out::println);
    }
  }
}
