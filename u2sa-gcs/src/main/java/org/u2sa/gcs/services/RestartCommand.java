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

/** {@code u2sa restart NAME}: ends a service, whatever state it is in, and starts it anew. */
@Command(
    name = "restart",
    description = {
      "Restart one service of a running system, whatever state it is in.",
      "",
      "Its launcher stops it and starts it again with the configuration in its file."
    })
public final class RestartCommand implements Callable<Integer> {
  @Spec private CommandSpec command;
  @Mixin private RemoteSystem remote;

  @Parameters(paramLabel = "NAME", description = "The service.")
  private String name;

  @Override
  public Integer call() throws InterruptedException {
    ServiceOrder order = new ServiceOrder().serviceName(name).action(ServiceAction.RESTART);
    return OrderToLauncher.give(
        remote, order, name + ": restarted", command.commandLine().getOut());
  }
}
