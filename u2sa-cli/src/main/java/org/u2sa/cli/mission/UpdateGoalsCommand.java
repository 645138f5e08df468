package org.u2sa.cli.mission;

import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code u2sa mission update}. */
@Command(
    name = "update",
    description = {
      "Change goals: the fields that a mission file gives replace those of the goals of the same names."
    })
final class UpdateGoalsCommand implements Callable<Integer> {
  @Spec private CommandSpec command;
  @Mixin private RemoteSystem remote;

  @Parameters(paramLabel = "FILE", description = "A mission file with the changed fields only.")
  private Path file;

  @Override
  public Integer call() throws InterruptedException {
    MissionOrder order = OrderToMissionManager.withGoals(MissionAction.UPDATE, file);
    return OrderToMissionManager.give(remote, order, command.commandLine().getOut());
  }
}
