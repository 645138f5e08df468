package org.u2sa.cli.describe;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.interfaces.RunFailedException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code u2sa describe}: shows a vehicle's composition and autonomy. */
@Command(
    name = "describe",
    description = {
      "Describe a vehicle: levels of autonomy and what justifies them, services, channels, sources, actuators.",
      "",
      "Reads its system file without starting it, or asks the running vehicle with --connect; "
          + "with both, shows the levels stated in the file beside those of the running system."
    })
public final class DescribeCommand extends BaseCommand {
  @Mixin private RemoteSystem remote;

  @Parameters(
      arity = "0..1",
      paramLabel = "SYSTEM FILE",
      description = "The vehicle's system file.")
  private Path file;

  @Option(names = "--connect", description = "Ask the vehicle running at --broker.")
  private boolean connect;

  @Option(names = "--variables", description = "Print the variables that configuration files set.")
  private boolean variables;

  @Option(names = "--json", description = "Print JSON.")
  private boolean json;

  @Override
  public Integer call() throws InterruptedException {
    if (file == null && !connect) {
      throw wrong("nothing to describe: expected a system file, --connect, or both");
    }
    Optional<SystemFile> system = Optional.ofNullable(file).map(SystemFile::read);
    return connect ? running(system) : planned(system.orElseThrow());
  }

  private int planned(SystemFile system) {
    try {
      print(CompositionOfFile.of(system));
    } catch (IOException e) {
      throw new RunFailedException("the services could not be created: " + e.getMessage(), e);
    }
    return ExitCode.DONE;
  }

  private int running(Optional<SystemFile> system) throws InterruptedException {
    try (RemoteLink link = remote.connect()) {
      VehicleComposition vehicle =
          CompositionOfRunning.of(
              link, remote.brokerAddress(), system.flatMap(SystemFile::autonomy));
      if (vehicle.services().isEmpty()) {
        throw remote.unanswered(
            link, link.systemId() + ": no service answered within " + link.timeoutS() + " s");
      }
      print(vehicle);
    }
    return ExitCode.DONE;
  }

  private void print(VehicleComposition vehicle) {
    if (json) {
      printBlock(DescriptionJson.text(vehicle));
    } else {
      new DescriptionText(vehicle, terminal(), variables).lines().forEach(out()::println);
    }
  }
}
