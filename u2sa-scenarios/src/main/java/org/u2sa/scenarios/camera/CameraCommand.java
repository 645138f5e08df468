package org.u2sa.scenarios.camera;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code u2sa camera}: parent of the camera commands. */
@Command(
    name = "camera",
    description = "Calibrate a camera with a chessboard; show what is recognised in its pictures.",
    subcommands = {CalibrateCommand.class, LookCommand.class})
final class CameraCommand implements Runnable {
  @Spec private CommandSpec command;

  @Override
  public void run() {
    throw new ParameterException(command.commandLine(), "expected calibrate or look");
  }
}
