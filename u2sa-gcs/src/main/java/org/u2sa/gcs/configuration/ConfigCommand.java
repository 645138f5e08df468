package org.u2sa.gcs.configuration;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code u2sa config}: alone it prints its help. */
@Command(
    name = "config",
    description = {
      "Show and change the variables of a running system's services.",
      "",
      "  ./u2sa config list PathPlanner",
      "  ./u2sa config set PathPlanner \"LOITER RADIUS=500\" \"AT END=HOLD\"",
      "  ./u2sa config undo PathPlanner"
    },
    subcommands = {ListCommand.class, GetCommand.class, SetCommand.class, UndoCommand.class})
public final class ConfigCommand implements Runnable {
  @Spec private CommandSpec command;

  @Override
  public void run() {
    command.commandLine().usage(command.commandLine().getOut());
  }
}
