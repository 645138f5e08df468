package org.u2sa.cli.mission;

import java.util.concurrent.Callable;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code u2sa mission resume}. */
@Command(
    name = "resume",
    description = {
      "Continue a paused mission.",
      "",
      "If it is not paused: return to where the mission was left, before goto or, with the variable RESUME = ORDERED, by the previous process."
    })
final class ResumeCommand implements Callable<Integer> {
  @Spec private CommandSpec command;
  @Mixin private RemoteSystem remote;

  @Override
  public Integer call() throws InterruptedException {
    MissionOrder order = new MissionOrder().action(MissionAction.RESUME);
    return OrderToMissionManager.give(remote, order, command.commandLine().getOut());
  }
}
