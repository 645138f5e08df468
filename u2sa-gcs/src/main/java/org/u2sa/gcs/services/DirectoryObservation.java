package org.u2sa.gcs.services;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.service.directory.KnownService;
import org.u2sa.service.directory.ServiceDirectory;

/** A command's live view of a running system's services. */
public final class DirectoryObservation {
  /** Time in which a service with the default report period reports twice. */
  private static final double LISTEN_S = 0.6;

  private final RemoteLink link;
  private final ServiceDirectory directory;
  private final long beganMicros;
  private final Map<String, ServiceCondition> conditions = new TreeMap<>(); // guarded by itself

  private DirectoryObservation(RemoteLink link) {
    this.link = link;
    directory = new ServiceDirectory(link.clock(), link::publish);
    beganMicros = link.clock().micros();
  }

  /** Starts listening, and asks all services. */
  public static DirectoryObservation begin(RemoteLink link) {
    DirectoryObservation observation = new DirectoryObservation(link);
    for (Channel<?> channel : ServiceDirectory.CHANNELS) {
      link.listen(channel, observation.directory::take);
    }
    link.listen(Channels.CONDITIONS, observation::note);
    observation.directory.ask();
    return observation;
  }

  /**
   * Calls {@link #begin}, then waits until all known services have answered or the link times out.
   */
  public static DirectoryObservation made(RemoteLink link) throws InterruptedException {
    DirectoryObservation observation = begin(link);
    link.await(observation::isComplete, link.timeoutS());
    return observation;
  }

  private boolean isComplete() {
    return areAmong(
        directory.services().stream()
            .filter(KnownService::isComplete)
            .map(KnownService::name)
            .collect(Collectors.toSet()));
  }

  /**
   * Whether the given names include each known service, after enough time to discover all. A
   * service counts from its first answer or health report. False while none is known.
   */
  public boolean areAmong(Set<String> names) {
    directory.refresh();
    List<String> heard = names();
    return link.clock().micros() - beganMicros >= Clock.micros(LISTEN_S)
        && !heard.isEmpty()
        && names.containsAll(heard);
  }

  private void note(ServiceCondition condition) {
    synchronized (conditions) {
      if (condition.condition() == Condition.UNWATCHED) {
        conditions.remove(condition.serviceName());
      } else {
        conditions.put(condition.serviceName(), condition);
      }
    }
  }

  /** The services present. */
  public ServiceDirectory directory() {
    return directory;
  }

  /** Names of the services present. */
  public List<String> names() {
    return directory.services().stream().map(KnownService::name).toList();
  }

  /** Last condition of each service from the health monitor; also of services that are gone. */
  Map<String, ServiceCondition> conditions() {
    synchronized (conditions) {
      return new TreeMap<>(conditions);
    }
  }

  /** All rows to show, by name: services present, and those known to be gone. */
  public List<ServiceRow> rows() {
    Map<String, ServiceRow> rows = new TreeMap<>();
    conditions().forEach((name, condition) -> rows.put(name, ServiceRow.gone(condition)));
    for (KnownService service : directory.services()) {
      rows.put(service.name(), ServiceRow.of(service, conditions().get(service.name())));
    }
    return new ArrayList<>(rows.values());
  }
}
