package org.u2sa.gcs.run;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.interfaces.Clock;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.messages.U2SAData;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.HealthReport;

/**
 * Learns under which names the services of a system file speak: a name is a matter of the service
 * and its configuration, so the running services are asked.
 */
final class ServiceNames implements Receiver, AutoCloseable {
  private static final int ASKS_AT_MOST = 20; // for each name that is nobody's of this file

  private final List<SystemFile.Entry> entries;
  private final Clock clock;
  private final Consumer<String> trouble;
  private final Map<String, String> entryNames = new ConcurrentHashMap<>(); // by service name
  private final Map<String, String> roles = new ConcurrentHashMap<>(); // by entry's simple name
  private final Map<String, Integer> asked = new ConcurrentHashMap<>(); // by service name
  private final Connection connection;
  private final String systemId;

  ServiceNames(SystemFile file, Transport transport, Clock clock, Consumer<String> trouble) {
    entries = file.services();
    systemId = file.systemId();
    this.clock = clock;
    this.trouble = trouble;
    connection = transport.connect("ServiceNames", this);
    connection.subscribe(Channels.DISCOVERY);
    connection.subscribe(Channels.HEALTH);
  }

  @Override
  public void receive(Channel<?> channel, U2SAData message) {
    if (message instanceof DiscoveryResponse response) {
      learn(response);
    } else if (message instanceof HealthReport report
        && !entryNames.containsKey(report.serviceName())
        && asked.merge(report.serviceName(), 1, Integer::sum) <= ASKS_AT_MOST) {
      ask();
    }
  }

  private void ask() {
    DiscoveryRequest request = new DiscoveryRequest();
    request.systemId(systemId);
    request.timestamp(clock.micros());
    request.freeze();
    connection.publish(Channels.DISCOVERY, request);
  }

  private void learn(DiscoveryResponse response) {
    for (SystemFile.Entry entry : entries) {
      if (response.className().equals(Optional.of(entry.className()))) {
        entryNames.put(response.serviceName(), entry.simpleName());
        roles.put(entry.simpleName(), response.serviceType());
      }
    }
  }

  /** The simple name of the entry whose service speaks under that name; also takes that itself. */
  Optional<String> entryOf(String serviceName) {
    String known = entryNames.get(serviceName);
    boolean itself = entries.stream().anyMatch(entry -> entry.simpleName().equals(serviceName));
    return known == null && itself ? Optional.of(serviceName) : Optional.ofNullable(known);
  }

  /** The role of the entry's service, as far as it has said so. */
  Optional<String> roleOf(String entryName) {
    return Optional.ofNullable(roles.get(entryName));
  }

  @Override
  public void trouble(String what) {
    trouble.accept(what);
  }

  @Override
  public void close() {
    connection.close();
  }
}
