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

/** {@code u2sa mission skip}. */
@Command(
    name = "skip",
    description = {"Skip a current goal: the mission continues as if it were done."})
final class SkipCommand implements Callable<Integer> {
  @Spec private CommandSpec command;
  @Mixin private RemoteSystem remote;

  @Parameters(
      arity = "0..1",
      paramLabel = "GOAL",
      description = "One of several current goals. Default: the only one.")
  private String goal;

  @Override
  public Integer call() throws InterruptedException {
    MissionOrder order = new MissionOrder().action(MissionAction.SKIP);
    if (goal != null) {
      order.uid(goal);
    }
    return OrderToMissionManager.give(remote, order, command.commandLine().getOut());
  }
}
