package org.u2sa.cli.mission;

import java.util.concurrent.Callable;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code u2sa mission pause}. */
@Command(
    name = "pause",
    description = {
      "Pause the mission: the vehicle stops, or circles if it cannot stop. Time limits are paused, too.",
      "",
      "resume continues with the same goal; goto and insert --now end the pause as well."
    })
final class PauseCommand implements Callable<Integer> {
  @Spec private CommandSpec command;
  @Mixin private RemoteSystem remote;

  @Override
  public Integer call() throws InterruptedException {
    MissionOrder order = new MissionOrder().action(MissionAction.PAUSE);
    return OrderToMissionManager.give(remote, order, command.commandLine().getOut());
  }
}
