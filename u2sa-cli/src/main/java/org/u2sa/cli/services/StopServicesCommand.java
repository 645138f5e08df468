package org.u2sa.cli.services;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.gcs.remote.Unanswered;
import org.u2sa.gcs.services.DirectoryObservation;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.xml.NearestNames;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.safety.StopCommand;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code u2sa stop [NAME]}: ends services in an orderly way and prints which have ended. */
@Command(
    name = "stop",
    description = {
      "Stop all services of a running system, or one by name.",
      "",
      "Each leaves its actuators neutral and closes its resources. Exit code 1: a service did "
          + "not confirm in time that it had ended. To stop all motion regardless of the services, see "
          + "u2sa estop."
    })
public final class StopServicesCommand extends BaseCommand {
  @Mixin private RemoteSystem remote;

  @Parameters(
      paramLabel = "NAME",
      arity = "0..1",
      description = "The service to stop. Default: all services of the system.")
  private String name;

  @Override
  public Integer call() throws InterruptedException {
    try (RemoteLink link = remote.connectForOrders()) {
      List<String> there = DirectoryObservation.made(link).names();
      if (name != null && !there.contains(name)) {
        throw new BadInputException(unknown(name, there, link));
      }
      Set<String> told = name == null ? new TreeSet<>(there) : Set.of(name);
      int code = report(told, stopped(link, told), link);
      if (code != ExitCode.DONE) {
        print("  " + Unanswered.EXPIRING);
      }
      if (told.isEmpty()) {
        remote.otherSystems(link).ifPresent(out()::println);
      } else if (code != ExitCode.DONE) {
        remote.explainRefusal();
      }
      return code;
    }
  }

  /** Error for an unknown service, listing the present ones. */
  static String unknown(String name, List<String> there, RemoteLink link) {
    return String.format(
        "no service \"%2$s\" found in system \"%1$s\"; found: %3$s%4$s",
        link.systemId(),
        name,
        there.isEmpty() ? "none" : String.join(", ", there),
        NearestNames.didYouMean(name, there));
  }

  private Map<String, ServiceStatus> stopped(RemoteLink link, Set<String> told)
      throws InterruptedException {
    Map<String, ServiceStatus> ends = new ConcurrentHashMap<>();
    link.listen(
        Channels.HEALTH,
        report -> {
          if (report.status() == ServiceStatus.STOPPED || report.status() == ServiceStatus.FAILED) {
            ends.put(report.serviceName(), report.status());
          }
        });
    StopCommand order = new StopCommand().stopAll(name == null);
    link.publish(Channels.STOP, name == null ? order : order.serviceName(name));
    link.await(() -> ends.keySet().containsAll(told), link.timeoutS());
    return ends;
  }

  private int report(Set<String> told, Map<String, ServiceStatus> ends, RemoteLink link) {
    boolean all = true;
    if (told.isEmpty()) {
      print("No service of system " + link.systemId() + " answered; the stop was sent.");
    }
    for (String service : told) {
      ServiceStatus end = ends.get(service);
      all &= end != null;
      print(
          service
              + (end == null
                  ? ": DID NOT CONFIRM its end within " + link.timeoutS() + " s"
                  : end == ServiceStatus.STOPPED ? ": stopped" : ": ended as failed"));
    }
    return all && !told.isEmpty() ? ExitCode.DONE : ExitCode.FAILED;
  }
}
