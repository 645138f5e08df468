package org.u2sa.gcs.services;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.service.directory.KnownService;
import org.u2sa.service.directory.ServiceDirectory;

/** What a command has heard of a running system's services so far, and goes on hearing. */
final class DirectoryObservation {
  /** In this time a service that reports as often as most do has reported twice. */
  private static final double LISTEN_S = 0.6;

  private final RemoteLink link;
  private final ServiceDirectory directory;
  private final Map<String, ServiceCondition> conditions = new TreeMap<>(); // guarded by itself

  private DirectoryObservation(RemoteLink link) {
    this.link = link;
    directory = new ServiceDirectory(link.clock(), link::publish);
  }

  /** Begins to listen, and asks all services. */
  static DirectoryObservation begin(RemoteLink link) {
    DirectoryObservation observation = new DirectoryObservation(link);
    for (Channel<?> channel : ServiceDirectory.CHANNELS) {
      link.listen(channel, observation.directory::take);
    }
    link.listen(Channels.CONDITIONS, observation::note);
    observation.directory.ask();
    return observation;
  }

  /** {@link #begin}, and waits until all that were heard have answered, or for the link's time. */
  static DirectoryObservation made(RemoteLink link) throws InterruptedException {
    DirectoryObservation observation = begin(link);
    long began = link.clock().micros();
    link.await(() -> observation.isComplete(began), link.timeoutS());
    return observation;
  }

  private boolean isComplete(long beganMicros) {
    directory.refresh();
    List<KnownService> heard = directory.services();
    return !heard.isEmpty()
        && heard.stream().allMatch(KnownService::isComplete)
        && link.clock().micros() - beganMicros >= Clock.micros(LISTEN_S);
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

  /** The services that are there. */
  ServiceDirectory directory() {
    return directory;
  }

  /** The names of the services that are there. */
  List<String> names() {
    return directory.services().stream().map(KnownService::name).toList();
  }

  /** What the health monitor last said of each service, those included that are gone. */
  Map<String, ServiceCondition> conditions() {
    synchronized (conditions) {
      return new TreeMap<>(conditions);
    }
  }

  /** All that is to be shown, by name: services that are there, and those known to be gone. */
  List<ServiceRow> rows() {
    Map<String, ServiceRow> rows = new TreeMap<>();
    conditions().forEach((name, condition) -> rows.put(name, ServiceRow.gone(condition)));
    for (KnownService service : directory.services()) {
      rows.put(service.name(), ServiceRow.of(service, conditions().get(service.name())));
    }
    return new ArrayList<>(rows.values());
  }
}
