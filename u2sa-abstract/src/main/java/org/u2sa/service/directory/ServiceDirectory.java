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
 * Who is there, and who offers which data: finds services by what they publish, not by name (thesis
 * 3.2.2.1, user story 7). A service or a tool hands it what it hears and asks it whenever it likes;
 * it asks the services by itself, and waits for nobody.
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
 *   directory.refresh(); // about once a second: asks newcomers, forgets who is silent
 *   for (Found found : directory.publishersOf(StateInformation.TYPE)) { … }
 * }
 * }</pre>
 *
 * A service is known from its first word on, and forgotten when it ends, when its connection
 * breaks, or when nothing was heard of it for {@link #LOST_AFTER_S}. Safe for several threads.
 */
public final class ServiceDirectory {
  /** What to subscribe to and hand to {@link #take}. */
  public static final List<Channel<?>> CHANNELS =
      List.of(Channels.DISCOVERY, Channels.FUNCTIONALITY, Channels.HEALTH, Channels.CONDITIONS);

  /** A service is forgotten when it was silent for so long [s], or for three of its intervals. */
  public static final double LOST_AFTER_S = 4.0;

  private static final int MAX_SERVICES = 1_000;
  private static final double INTERVALS = 3.0;
  private static final long ASK_AGAIN_MICROS = Clock.MICROS_PER_SECOND;

  private final Clock clock;
  private final Asking asking;
  private final Map<String, Entry> entries = new TreeMap<>();
  private long askedMicros = Long.MIN_VALUE; // when all were asked last

  /** How requests leave: a service's or a connection's publish. */
  @FunctionalInterface
  public interface Asking {
    /** Publishes a request; must not wait. What becomes of it shows in the answers. */
    void publish(Channel<?> channel, U2SAData request);
  }

  /** A service and when it was heard last. */
  private static final class Entry {
    private KnownService service;
    private long heardMicros;

    Entry(String name) {
      service = KnownService.named(name);
    }
  }

  /**
   * An empty directory.
   *
   * @param clock the time of the run
   * @param asking publishes requests
   */
  public ServiceDirectory(Clock clock, Asking asking) {
    this.clock = clock;
    this.asking = asking;
  }

  /** Asks all services who they are and what they offer. Call it once at the start. */
  public void ask() {
    synchronized (this) {
      askedMicros = clock.micros();
    }
    asking.publish(Channels.DISCOVERY, new DiscoveryRequest());
    asking.publish(Channels.FUNCTIONALITY, new FunctionalityRequest().serviceName(""));
  }

  /**
   * Takes note of a message.
   *
   * @return whether the directory has a use for it
   */
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
      return; // of a system that has far fewer: somebody invents names
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
      entries.remove(name); // an end of another instance is no end of this one
    }
  }

  private synchronized void takeCondition(ServiceCondition condition) {
    Entry entry = entries.get(condition.serviceName());
    if (entry != null) { // retained ones speak of services that are long gone
      entry.service = entry.service.with(condition);
    }
  }

  /** The service as before, or with nothing known if this is another start of it. */
  private static KnownService restarted(KnownService known, Optional<String> instance) {
    return isSame(known.instance(), instance) ? known : KnownService.named(known.name());
  }

  private static boolean isSame(Optional<String> one, Optional<String> other) {
    return !one.isPresent() || !other.isPresent() || one.equals(other);
  }

  /**
   * Forgets who was silent for too long, and asks again while anybody has not said all. Call it
   * about once a second.
   */
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

  /** The service of that name, if it is there. */
  public synchronized Optional<KnownService> service(String name) {
    return Optional.ofNullable(entries.get(name)).map(entry -> entry.service);
  }

  /** Who publishes messages of the type, subclasses included; the certain ones first. */
  public List<Found> publishersOf(MessageType<?> type) {
    return publishersOf(type.chain());
  }

  /** {@link #publishersOf(MessageType)} of a type that is known by its chain only, base first. */
  public List<Found> publishersOf(List<String> typeChain) {
    return found(typeChain, KnownService::publishes);
  }

  /** Who is handed messages of the type where they are published; the certain ones first. */
  public List<Found> subscribersOf(MessageType<?> type) {
    return subscribersOf(type.chain());
  }

  /** {@link #subscribersOf(MessageType)} of a type that is known by its chain only, base first. */
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
   * A service that has to do with a type of data, and how.
   *
   * @param service the service
   * @param offer the channel and the type that it named
   * @param certain whether all that travels on the channel is of the type asked for; otherwise the
   *     type is a subclass of the channel's, so that messages of it may travel there among others
   */
  public record Found(KnownService service, DataOffer offer, boolean certain) {}
}
