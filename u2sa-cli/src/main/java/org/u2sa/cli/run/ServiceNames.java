package org.u2sa.cli.run;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.ConnectionLost;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.schema.U2SAData;

/**
 * Maps system-file entries to service names: from the files if they contain the name, otherwise by
 * asking the running services.
 *
 * <p>Any client may pose as a service, so an answer never changes a known name or role: an entry
 * has one name and a name one entry, and the first answer from the run's own processes counts.
 */
final class ServiceNames implements Receiver, AutoCloseable {
  private static final int ASKS_AT_MOST = 20; // requests per unknown name

  private static final int MAX_NAMES = 1_000; // unknown names

  private final List<SystemFile.Entry> entries;
  private final Predicate<String> own;
  private final Clock clock;
  private final Consumer<String> trouble;
  private final Map<String, String> entryNames = new ConcurrentHashMap<>(); // by service name
  private final Map<String, String> serviceNames = new ConcurrentHashMap<>(); // by entry name
  private final Map<String, Word> words = new ConcurrentHashMap<>(); // by service name
  private final Map<String, Integer> asked = new ConcurrentHashMap<>(); // by service name
  private final Connection connection;
  private final String systemId;

  /**
   * Last report of a service: its instance, time of receipt [µs], and whether it announced its
   * stop.
   */
  record Word(String instance, long atMicros, boolean isLast) {}

  /**
   * @param own whether a service name is one of the run's processes, as far as that can be known
   */
  ServiceNames(
      SystemFile file,
      KnownNames known,
      Predicate<String> own,
      Transport transport,
      Clock clock,
      Consumer<String> trouble) {
    this.own = own;
    entries = file.services();
    systemId = file.systemId();
    this.clock = clock;
    this.trouble = trouble;
    entries.forEach(entry -> known.of(entry).ifPresent(name -> bind(name, entry.simpleName())));
    connection = transport.connect("ServiceNames", this);
    connection.subscribe(Channels.DISCOVERY);
    connection.subscribe(Channels.HEALTH);
  }

  @Override
  public void receive(Channel<?> channel, U2SAData message) {
    if (message instanceof DiscoveryResponse response) {
      learn(response);
    } else if (message instanceof HealthReport report && !(message instanceof ConnectionLost)) {
      hear(report);
    }
  }

  private void hear(HealthReport report) {
    String name = report.serviceName();
    if (asked.size() >= MAX_NAMES && !asked.containsKey(name) && !entryNames.containsKey(name)) {
      return; // a client is making up names
    }
    if (report.threadAlive().isEmpty()) { // sent by the service itself
      boolean isLast = report.status() == ServiceStatus.STOPPED;
      words.put(name, new Word(report.instance().orElse(""), clock.micros(), isLast));
    }
    if (!entryNames.containsKey(name) && asked.merge(name, 1, Integer::sum) <= ASKS_AT_MOST) {
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
    String name = response.serviceName();
    for (SystemFile.Entry entry : entries) {
      if (response.className().equals(Optional.of(entry.className()))
          && (name.equals(entry.simpleName()) || !isEntry(name))
          && own.test(name)) {
        bind(name, entry.simpleName());
      }
    }
  }

  /** Binds the two to each other, unless one of them is already bound. */
  private synchronized void bind(String serviceName, String entryName) {
    if (!serviceNames.containsKey(entryName)
        && entryNames.putIfAbsent(serviceName, entryName) == null) {
      serviceNames.put(entryName, serviceName);
    }
  }

  private boolean isEntry(String name) {
    return entries.stream().anyMatch(entry -> entry.simpleName().equals(name));
  }

  /** Returns the simple entry name for a service name; also accepts an entry name. */
  Optional<String> entryOf(String serviceName) {
    String known = entryNames.get(serviceName);
    return known == null && isEntry(serviceName)
        ? Optional.of(serviceName)
        : Optional.ofNullable(known);
  }

  Optional<String> nameOf(String entryName) {
    return Optional.ofNullable(serviceNames.get(entryName));
  }

  List<String> monitors() {
    return entries.stream()
        .filter(KnownNames::isMonitor)
        .map(SystemFile.Entry::simpleName)
        .toList();
  }

  /** Returns the last status reported by the service itself. */
  Optional<Word> lastWord(String serviceName) {
    return Optional.ofNullable(words.get(serviceName));
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
