package org.u2sa.gcs.services;

import java.io.PrintWriter;
import java.util.List;
import java.util.UUID;
import org.u2sa.gcs.command.ExitCode;
import org.u2sa.gcs.command.RunFailedException;
import org.u2sa.gcs.remote.Question;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.gcs.remote.RemoteSystem;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.ServiceOrder;
import org.u2sa.messages.contract.ServiceOrderResult;

/** Gives an order to the launcher that runs a service, and says what came of it. */
final class OrderToLauncher {
  private OrderToLauncher() {}

  /**
   * Sends the order and waits for its result.
   *
   * @param order without request ID and operator
   * @param done what to say when it was carried out
   * @throws RunFailedException if it was refused, or if no launcher answered in time
   */
  static int give(RemoteSystem remote, ServiceOrder order, String done, PrintWriter out)
      throws InterruptedException {
    String id = UUID.randomUUID().toString();
    String what = order.action() + " " + order.serviceName();
    try (RemoteLink link = remote.connect()) {
      List<ServiceOrderResult> results =
          link.ask(
              new Question<>(
                      Channels.SERVICE_ORDERS,
                      order.requestId(id).operator(RemoteSystem.operator()),
                      ServiceOrderResult.class)
                  .only(result -> result.requestId().equals(id))
                  .first());
      if (results.isEmpty()) {
        throw new RunFailedException(
            nobody(what, order.serviceName(), link)
                + remote.otherSystems(link).map(others -> ";" + others.substring(1)).orElse(""));
      }
      ServiceOrderResult result = results.get(0);
      if (!result.accepted()) {
        throw new RunFailedException(what + " was not done: " + result.reason());
      }
      out.println(done);
      return ExitCode.DONE;
    }
  }

  private static String nobody(String what, String service, RemoteLink link)
      throws InterruptedException {
    List<String> there = DirectoryObservation.made(link).names();
    String within = what + ": no launcher answered within " + link.timeoutS() + " s";
    return there.contains(service)
        ? within + "; it may still be working (--timeout waits longer)"
        : within + "; " + StopServicesCommand.unknown(service, there, link);
  }
}
