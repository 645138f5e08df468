package org.u2sa.gcs.services;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.FunctionalityResponse;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.directory.KnownService;

/**
 * A {@link DirectoryObservation} of a settled system: all known services have answered twice with
 * the same result, and none is newly created. A starting system answers service by service, and a
 * single answer could show a channel without subscribers whose subscriber is about to appear.
 */
public final class SettledObservation {
  /** Maximum time between the creation of two services of a starting system [s]. */
  private static final double YOUNG_S = 2.0;

  private static final double ROUND_S = 0.6; // two health reports at the usual interval

  private final RemoteLink link;
  private final DirectoryObservation observation;
  private final Set<String> answered = ConcurrentHashMap.newKeySet(); // since the last question
  private boolean settled;

  private SettledObservation(RemoteLink link, DirectoryObservation observation) {
    this.link = link;
    this.observation = observation;
  }

  /** Observes until the system has settled, or for the link's timeout. */
  public static SettledObservation made(RemoteLink link) throws InterruptedException {
    long began = link.clock().micros();
    SettledObservation made = new SettledObservation(link, DirectoryObservation.made(link));
    link.listen(Channels.FUNCTIONALITY, made::note);
    made.settle(began + Clock.micros(link.timeoutS()));
    return made;
  }

  private void note(U2SAData message) {
    if (message instanceof FunctionalityResponse response) {
      answered.add(response.serviceName());
    }
  }

  private void settle(long deadlineMicros) throws InterruptedException {
    Map<String, List<?>> before = offers();
    while (!settled && link.clock().micros() < deadlineMicros) {
      boolean all = askedAgain(deadlineMicros);
      Map<String, List<?>> after = offers();
      settled = all && after.equals(before) && !isYoung();
      before = after;
    }
  }

  /** Queries all services again; returns whether all known services have answered. */
  private boolean askedAgain(long deadlineMicros) throws InterruptedException {
    answered.clear();
    observation.directory().ask();
    long began = link.clock().micros();
    link.await(
        () -> {
          observation.directory().refresh();
          return haveAllAnswered() && link.clock().micros() - began >= Clock.micros(ROUND_S);
        },
        Clock.seconds(deadlineMicros - began));
    return haveAllAnswered();
  }

  private boolean haveAllAnswered() {
    return answered.containsAll(observation.names());
  }

  private Map<String, List<?>> offers() {
    Map<String, List<?>> offers = new HashMap<>();
    for (KnownService service : observation.directory().services()) {
      offers.put(service.name(), List.of(service.publishes(), service.subscribes()));
    }
    return offers;
  }

  private boolean isYoung() {
    return observation.directory().services().stream()
        .flatMap(service -> service.discovery().stream())
        .mapToDouble(DiscoveryResponse::uptime)
        .anyMatch(uptimeS -> uptimeS < YOUNG_S);
  }

  /** The observed services. */
  public DirectoryObservation observation() {
    return observation;
  }

  /** Whether the system has settled; otherwise services or channels may be missing. */
  public boolean hasSettled() {
    return settled;
  }
}
