package org.u2sa.trials.world;

import java.util.List;
import org.u2sa.cli.command.CommandProvider;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Adds {@code u2sa world} to the command line. */
public final class WorldCommands implements CommandProvider {
  @Command(
      name = "world",
      description = "Check a world file, of U2SA or of Gazebo.",
      subcommands = CheckCommand.class)
  private static final class WorldCommand implements Runnable {
    @Spec private CommandSpec command;

    @Override
    public void run() {
      throw new ParameterException(command.commandLine(), "expected check");
    }
  }

  @Override
  public List<Contribution> commands() {
    return List.of(new Contribution(Group.TOP_LEVEL, new WorldCommand()));
  }
}
