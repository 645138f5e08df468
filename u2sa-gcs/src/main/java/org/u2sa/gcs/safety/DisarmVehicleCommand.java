package org.u2sa.gcs.safety;

import java.util.concurrent.Callable;
import org.u2sa.gcs.remote.RemoteSystem;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code u2sa disarm}: lets a vehicle no longer move. */
@Command(
    name = "disarm",
    description = {
      "Disarm a vehicle, even in mid-air.",
      "",
      "Actuators whose variable REQUIRES ARMING is true go neutral; failsafes no longer act."
    })
public final class DisarmVehicleCommand implements Callable<Integer> {
  @Spec private CommandSpec command;
  @Mixin private RemoteSystem remote;

  @Override
  public Integer call() throws InterruptedException {
    return ArmingOrder.give(remote, false, command.commandLine().getOut());
  }
}
