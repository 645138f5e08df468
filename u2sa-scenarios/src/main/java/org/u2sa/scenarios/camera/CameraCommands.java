package org.u2sa.scenarios.camera;

import java.util.List;
import org.u2sa.cli.command.CommandProvider;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Adds {@code u2sa camera} to the command line. */
public final class CameraCommands implements CommandProvider {
  @Command(
      name = "camera",
      description = "Calibrate a camera with a chessboard; show what is detected in its pictures.",
      subcommands = {CalibrateCommand.class, LookCommand.class})
  private static final class CameraCommand implements Runnable {
    @Spec private CommandSpec command;

    @Override
    public void run() {
      throw new ParameterException(command.commandLine(), "expected calibrate or look");
    }
  }

  @Override
  public List<Contribution> commands() {
    return List.of(new Contribution(Group.TOP_LEVEL, new CameraCommand()));
  }
}
