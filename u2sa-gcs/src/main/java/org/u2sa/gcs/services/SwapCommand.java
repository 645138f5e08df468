package org.u2sa.gcs.services;

import java.util.concurrent.Callable;
import org.u2sa.gcs.remote.RemoteSystem;
import org.u2sa.messages.contract.ServiceAction;
import org.u2sa.messages.contract.ServiceOrder;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code u2sa swap NAME CLASS}: puts another implementation in the place of a running service. */
@Command(
    name = "swap",
    description = {
      "Replace a running service with another class while the vehicle moves.",
      "",
      "The new service starts and takes over state, name and connection; only then does the old one end. If the new one cannot "
          + "start, nothing changes."
    })
public final class SwapCommand implements Callable<Integer> {
  @Spec private CommandSpec command;
  @Mixin private RemoteSystem remote;

  @Parameters(index = "0", paramLabel = "NAME", description = "The service to replace.")
  private String name;

  @Parameters(
      index = "1",
      paramLabel = "CLASS",
      description = "The full name of the class that takes its place, on the system's class path.")
  private String className;

  @Override
  public Integer call() throws InterruptedException {
    ServiceOrder order =
        new ServiceOrder().serviceName(name).action(ServiceAction.SWAP).className(className);
    return OrderToLauncher.give(
        remote, order, name + ": runs as " + className, command.commandLine().getOut());
  }
}
