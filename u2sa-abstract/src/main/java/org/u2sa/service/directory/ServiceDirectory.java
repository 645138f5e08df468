package org.u2sa.service.directory;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Function;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.ConnectionLost;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.FunctionalityRequest;
import org.u2sa.messages.contract.FunctionalityResponse;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.U2SAData;

/**
 * Directory of the services present and the data they offer: finds services by what they publish,
 * not by name (thesis 3.2.2.1, user story 7). A service or tool passes received messages to it and
 * can query it at any time; it queries services automatically and never blocks.
 *
 * <pre>{@code
 * private final ServiceDirectory directory = new ServiceDirectory(clock(), this::publish);
 *
 * // in the constructor
 * ServiceDirectory.CHANNELS.forEach(this::registerSubscriber);
 *
 * public void callback(U2SAData data) {
 *   directory.take(data);
 * }
 *
 * protected void step(double nowS) {
 *   directory.refresh(); // about once a second: queries newcomers, drops silent services
 *   for (Found found : directory.publishersOf(StateInformation.TYPE)) { … }
 * }
 * }</pre>
 *
 * A service is known from its first message on, and forgotten when it ends, when its connection
 * breaks, or when it has been silent for {@link #LOST_AFTER_S}. Thread-safe.
 */
public final class ServiceDirectory {
  /** Channels whose messages must be passed to {@link #take}. */
  public static final List<Channel<?>> CHANNELS =
      List.of(Channels.DISCOVERY, Channels.FUNCTIONALITY, Channels.HEALTH, Channels.CONDITIONS);

  /** Silence after which a service is forgotten [s], unless three of its intervals are longer. */
  public static final double LOST_AFTER_S = 4.0;

  private static final int MAX_SERVICES = 1_000;
  private static final double INTERVALS = 3.0;
  private static final long ASK_AGAIN_MICROS = Clock.MICROS_PER_SECOND;

  private final Clock clock;
  private final Asking asking;
  private final Map<String, Entry> entries = new TreeMap<>();
  private long askedMicros = Long.MIN_VALUE; // time of the last request to all

  /** The publish method of a service or connection. */
  @FunctionalInterface
  public interface Asking {
    /** Publishes a request; must not block. */
    void publish(Channel<?> channel, U2SAData request);
  }

  private static final class Entry {
    private KnownService service;
    private long heardMicros;

    Entry(String name) {
      service = KnownService.named(name);
    }
  }

  /**
   * @param asking publishes requests
   */
  public ServiceDirectory(Clock clock, Asking asking) {
    this.clock = clock;
    this.asking = asking;
  }

  /** Requests identity and functionality of all services. Call it once at the start. */
  public void ask() {
    synchronized (this) {
      askedMicros = clock.micros();
    }
    asking.publish(Channels.DISCOVERY, new DiscoveryRequest());
    asking.publish(Channels.FUNCTIONALITY, new FunctionalityRequest().serviceName(""));
  }

  /** Processes a message, and returns whether it was used. */
  public boolean take(U2SAData message) {
    if (message instanceof DiscoveryResponse response) {
      note(response.serviceName(), known -> restarted(known, response.instance()).with(response));
    } else if (message instanceof FunctionalityResponse response) {
      note(response.serviceName(), known -> known.with(response));
    } else if (message instanceof HealthReport report) {
      takeHealth(report);
    } else if (message instanceof ServiceCondition condition) {
      takeCondition(condition);
    } else {
      return false;
    }
    return true;
  }

  private synchronized void note(String name, Function<KnownService, KnownService> change) {
    if (entries.size() >= MAX_SERVICES && !entries.containsKey(name)) {
      return; // more than any real system: invented names
    }
    Entry entry = entries.computeIfAbsent(name, Entry::new);
    entry.service = change.apply(entry.service);
    entry.heardMicros = clock.micros();
  }

  private synchronized void takeHealth(HealthReport report) {
    String name = report.serviceName();
    boolean over =
        report instanceof ConnectionLost
            || report.status() == ServiceStatus.STOPPED
            || report.status() == ServiceStatus.FAILED;
    if (!over) {
      note(name, known -> restarted(known, report.instance()).with(report));
    } else if (entries.containsKey(name)
        && isSame(entries.get(name).service.instance(), report.instance())) {
      entries.remove(name); // the end of another instance does not concern this one
    }
  }

  private synchronized void takeCondition(ServiceCondition condition) {
    Entry entry = entries.get(condition.serviceName());
    if (entry != null) { // retained messages may be from services that ended long ago
      entry.service = entry.service.with(condition);
    }
  }

  /** The known service, or a reset entry if it has been restarted. */
  private static KnownService restarted(KnownService known, Optional<String> instance) {
    return isSame(known.instance(), instance) ? known : KnownService.named(known.name());
  }

  private static boolean isSame(Optional<String> one, Optional<String> other) {
    return !one.isPresent() || !other.isPresent() || one.equals(other);
  }

  /** Drops silent services, and repeats unanswered requests. Call it about once a second. */
  public void refresh() {
    boolean missing = false;
    synchronized (this) {
      long now = clock.micros();
      entries.values().removeIf(entry -> now - entry.heardMicros > lostAfterMicros(entry));
      for (Entry entry : entries.values()) {
        missing |= !entry.service.isComplete();
      }
      missing &= askedMicros == Long.MIN_VALUE || now - askedMicros >= ASK_AGAIN_MICROS;
    }
    if (missing) {
      ask();
    }
  }

  private static long lostAfterMicros(Entry entry) {
    double intervals = INTERVALS * entry.service.healthIntervalS().orElse(0.0);
    return Clock.micros(Math.max(LOST_AFTER_S, intervals));
  }

  /** All services, by name. */
  public synchronized List<KnownService> services() {
    List<KnownService> all = new ArrayList<>();
    entries.values().forEach(entry -> all.add(entry.service));
    return all;
  }

  public synchronized Optional<KnownService> service(String name) {
    return Optional.ofNullable(entries.get(name)).map(entry -> entry.service);
  }

  /** Publishers of messages of the type, including subclasses; certain ones first. */
  public List<Found> publishersOf(MessageType<?> type) {
    return publishersOf(type.chain());
  }

  /** {@link #publishersOf(MessageType)} for a type known only by its chain, topmost first. */
  public List<Found> publishersOf(List<String> typeChain) {
    return found(typeChain, KnownService::publishes);
  }

  /** Subscribers that receive messages of the type when published; certain ones first. */
  public List<Found> subscribersOf(MessageType<?> type) {
    return subscribersOf(type.chain());
  }

  /** {@link #subscribersOf(MessageType)} for a type known only by its chain, topmost first. */
  public List<Found> subscribersOf(List<String> typeChain) {
    return found(typeChain, KnownService::subscribes);
  }

  private List<Found> found(
      List<String> typeChain, Function<KnownService, List<DataOffer>> offers) {
    List<Found> certain = new ArrayList<>();
    List<Found> possible = new ArrayList<>();
    for (KnownService service : services()) {
      for (DataOffer offer : offers.apply(service)) {
        if (offer.isAlways(typeChain)) {
          certain.add(new Found(service, offer, true));
        } else if (offer.mayBe(typeChain)) {
          possible.add(new Found(service, offer, false));
        }
      }
    }
    certain.addAll(possible);
    return certain;
  }

  /**
   * A service related to a type of data.
   *
   * @param certain whether all messages of the channel are of the requested type; otherwise only
   *     some may be
   */
  public record Found(KnownService service, DataOffer offer, boolean certain) {}
}
