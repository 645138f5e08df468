package org.u2sa.trials.simulate;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.sim.file.VehicleCheck;
import org.u2sa.sim.file.VehicleFile;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code u2sa vehicle}: commands for vehicle files. */
@Command(
    name = "vehicle",
    description = "Check a vehicle file and measure the vehicle's performance.",
    subcommands = VehicleCommand.Check.class)
final class VehicleCommand implements Callable<Integer> {
  @Spec private CommandSpec command;

  @Override
  public Integer call() {
    command.commandLine().usage(command.commandLine().getOut());
    return ExitCode.DONE;
  }

  /** {@code u2sa vehicle check}. */
  @Command(
      name = "check",
      description = {
        "Check a vehicle file and print the vehicle's performance.",
        "",
        "The performance of ground vehicles and vessels is measured by simulating them on level "
            + "ground or in still water, that of aircraft is computed for calm air at sea level."
      })
  static final class Check implements Callable<Integer> {
    @Parameters(paramLabel = "FILE", description = "Vehicle file (XML).")
    private Path file;

    @Spec private CommandSpec command;

    @Override
    public Integer call() {
      PrintWriter out = command.commandLine().getOut();
      VehicleFile vehicle = VehicleFile.load(file);
      try {
        VehicleCheck.lines(vehicle).forEach(out::println);
      } catch (IllegalArgumentException e) { // invalid combination of valid values
        throw new BadInputException(file + ": cannot be simulated: " + e.getMessage(), e);
      }
      return ExitCode.DONE;
    }
  }
}
