package org.u2sa.cli.mission;

import java.util.concurrent.Callable;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code u2sa mission goto}. */
@Command(
    name = "goto",
    description = {
      "Pursue a goal now; the mission continues from there.",
      "",
      "resume goes back to where the mission was."
    })
final class GoToCommand implements Callable<Integer> {
  @Spec private CommandSpec command;
  @Mixin private RemoteSystem remote;

  @Parameters(paramLabel = "GOAL", description = "The goal; home if the mission has one.")
  private String goal;

  @Override
  public Integer call() throws InterruptedException {
    MissionOrder order = new MissionOrder().action(MissionAction.GOTO).uid(goal);
    return OrderToMissionManager.give(remote, order, command.commandLine().getOut());
  }
}
