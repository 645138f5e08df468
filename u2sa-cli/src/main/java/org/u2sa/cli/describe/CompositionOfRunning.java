package org.u2sa.cli.describe;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.u2sa.cli.describe.VehicleComposition.AnnouncedActuator;
import org.u2sa.cli.describe.VehicleComposition.ComposedService;
import org.u2sa.cli.describe.VehicleComposition.HeardSource;
import org.u2sa.core.launch.AutonomyLevels;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.directory.DataOffer;
import org.u2sa.service.directory.KnownService;
import org.u2sa.service.directory.ServiceDirectory;

/**
 * Determines a running vehicle's composition from its services' answers and its sensors' messages.
 */
final class CompositionOfRunning {
  /** Listening time, sufficient for sources faster than 1 Hz [s]. */
  private static final double LISTEN_S = 2.0;

  private static final List<Channel<?>> MEASURED =
      List.of(Channels.SENSED_STATE, Channels.SENSED_OBJECTS, Channels.SCANS, Channels.STATE);

  private final RemoteLink link;
  private final ServiceDirectory directory;
  private final Map<String, SourceRecord> sources = new TreeMap<>(); // guarded by itself
  private final Map<String, AnnouncedActuator> actuators = new TreeMap<>(); // guarded by itself

  private CompositionOfRunning(RemoteLink link) {
    this.link = link;
    directory = new ServiceDirectory(link.clock(), link::publish);
  }

  /** Listens for a fixed time; {@code stated} is the autonomy stated in the vehicle's file. */
  static VehicleComposition of(RemoteLink link, String origin, Optional<AutonomyLevels> stated)
      throws InterruptedException {
    CompositionOfRunning running = new CompositionOfRunning(link);
    running.listen();
    return new VehicleComposition(
        link.systemId(),
        origin,
        true,
        stated,
        running.services(),
        running.sources(),
        running.actuators());
  }

  private void listen() throws InterruptedException {
    for (Channel<?> channel : ServiceDirectory.CHANNELS) {
      link.listen(channel, directory::take);
    }
    for (Channel<?> channel : MEASURED) {
      link.listen(channel, message -> measured(channel, message));
    }
    link.listen(Channels.ACTUATORS, this::announced);
    directory.ask();
    long began = link.clock().micros();
    link.await(() -> isComplete(began), Math.max(LISTEN_S, link.timeoutS()));
  }

  private boolean isComplete(long beganMicros) {
    directory.refresh();
    List<KnownService> heard = directory.services();
    return !heard.isEmpty()
        && heard.stream().allMatch(KnownService::isComplete)
        && link.clock().micros() - beganMicros >= Clock.micros(LISTEN_S);
  }

  private void measured(Channel<?> channel, U2SAData message) {
    synchronized (sources) {
      SourceRecord source = new SourceRecord(channel.name(), message);
      sources.merge(source.key(), source, SourceRecord::with);
    }
  }

  private void announced(U2SAData message) {
    if (message instanceof ActuatorAnnouncement announcement) {
      synchronized (actuators) {
        actuators.put(announcement.actuatorName(), AnnouncedActuator.of(announcement));
      }
    }
  }

  private List<ComposedService> services() {
    List<ComposedService> services = new ArrayList<>();
    for (KnownService service : directory.services()) {
      services.add(
          new ComposedService(
              service.name(),
              service.discovery().map(DiscoveryResponse::serviceType).orElse(""),
              service.discovery().flatMap(DiscoveryResponse::className).orElse(""),
              "",
              Map.of(),
              Map.of(),
              channels(service.publishes()),
              channels(service.subscribes()),
              service.isComplete() ? "" : "has not answered functionality requests"));
    }
    return services;
  }

  private static List<String> channels(List<DataOffer> offers) {
    return offers.stream().map(DataOffer::channel).distinct().toList();
  }

  private List<HeardSource> sources() {
    synchronized (sources) {
      return sources.values().stream().map(SourceRecord::heard).toList();
    }
  }

  private List<AnnouncedActuator> actuators() {
    synchronized (actuators) {
      return new ArrayList<>(actuators.values());
    }
  }
}
