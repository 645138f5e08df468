package org.u2sa.gcs.safety;

import java.util.concurrent.Callable;
import org.u2sa.gcs.remote.RemoteSystem;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code u2sa arm}: lets a vehicle move, or says why not. */
@Command(
    name = "arm",
    description = {
      "Arm a vehicle, or say why it cannot be armed.",
      "",
      "Its Safety Manager checks services, state, battery, fence, mission and actuators. Of an armed vehicle it ends a RETURN "
          + "or LAND whose cause is gone."
    })
public final class ArmVehicleCommand implements Callable<Integer> {
  @Spec private CommandSpec command;
  @Mixin private RemoteSystem remote;

  @Override
  public Integer call() throws InterruptedException {
    return ArmingOrder.give(remote, true, command.commandLine().getOut());
  }
}
