package org.u2sa.cli.services;

import java.util.List;
import java.util.Optional;
import java.util.UUID;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.gcs.remote.Operator;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.gcs.remote.Unanswered;
import org.u2sa.gcs.services.DirectoryObservation;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.ServiceAction;
import org.u2sa.messages.contract.ServiceOrder;
import org.u2sa.messages.contract.ServiceOrderResult;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** Sends an order to a service's launcher, and prints the result. */
public abstract class LauncherCommand extends BaseCommand {
  @Mixin private RemoteSystem remote;

  private LauncherCommand() {}

  /** {@code u2sa restart NAME}: ends a service, regardless of its state, and starts it again. */
  @Command(
      name = "restart",
      description = {
        "Restart one service of a running system, regardless of its state.",
        "",
        "Its launcher stops it and starts it again with the configuration in its file."
      })
  public static final class Restart extends LauncherCommand {
    @Parameters(paramLabel = "NAME", description = "The service.")
    private String name;

    @Override
    public Integer call() throws InterruptedException {
      return give(
          new ServiceOrder().serviceName(name).action(ServiceAction.RESTART), name + ": restarted");
    }
  }

  /** {@code u2sa swap NAME CLASS}: replaces a running service with another implementation. */
  @Command(
      name = "swap",
      description = {
        "Replace a running service with another class while the vehicle moves.",
        "",
        "The new service starts and takes over state, name and connection; only then does the "
            + "old service end. If the new one cannot "
            + "start, nothing changes."
      })
  public static final class Swap extends LauncherCommand {
    @Parameters(index = "0", paramLabel = "NAME", description = "The service to replace.")
    private String name;

    @Parameters(
        index = "1",
        paramLabel = "CLASS",
        description = "Fully qualified name of the new class, on the system's class path.")
    private String className;

    @Override
    public Integer call() throws InterruptedException {
      return give(
          new ServiceOrder().serviceName(name).action(ServiceAction.SWAP).className(className),
          name + ": runs as " + className);
    }
  }

  /**
   * Sends the order and waits for its result.
   *
   * @param order without request ID and operator
   * @param done printed on success
   * @throws RunFailedException if it was rejected, or if no launcher answered in time
   */
  final int give(ServiceOrder order, String done) throws InterruptedException {
    String id = UUID.randomUUID().toString();
    String what = order.action() + " " + order.serviceName();
    try (RemoteLink link = remote.connect()) {
      Optional<ServiceOrderResult> result =
          link.first(
              Channels.SERVICE_ORDERS,
              order.requestId(id).operator(Operator.name()),
              ServiceOrderResult.class,
              each -> each.requestId().equals(id));
      if (result.isEmpty()) {
        throw remote.unanswered(link, nobody(what, order.serviceName(), link));
      }
      if (!result.get().accepted()) {
        throw new RunFailedException(what + " was not carried out: " + result.get().reason());
      }
      print(done);
      return ExitCode.DONE;
    }
  }

  private static String nobody(String what, String service, RemoteLink link)
      throws InterruptedException {
    List<String> there = DirectoryObservation.made(link).names();
    String within = what + ": no launcher answered within " + link.timeoutS() + " s";
    return there.contains(service)
        ? within + " (--timeout waits longer); " + Unanswered.LASTING
        : within + "; " + StopServicesCommand.unknown(service, there, link);
  }
}
