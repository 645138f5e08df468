package org.u2sa.core.communication.discovery;

import java.io.IOException;
import java.net.InetAddress;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Collectors;
import javax.jmdns.JmDNS;
import javax.jmdns.ServiceEvent;
import javax.jmdns.ServiceInfo;
import javax.jmdns.ServiceListener;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.time.Clock;

/**
 * Finds brokers of U2SA systems on the local networks by multicast DNS. Announcements can be
 * forged; TLS authenticates the broker.
 */
public final class BrokerSearch implements ServiceListener {
  /** Placeholder for a broker's address that requests a search. */
  public static final String AUTO = "auto";

  /** How long to wait for further brokers after the first [s]. */
  private static final double OTHERS_S = 1.0;

  private final Optional<String> systemId;
  private final Clock clock;
  private final Clock.Waiter waiter;
  private final Map<String, FoundBroker> found = new ConcurrentHashMap<>(); // by ID

  private BrokerSearch(Optional<String> systemId, Clock clock, Clock.Waiter waiter) {
    this.systemId = systemId;
    this.clock = clock;
    this.waiter = waiter;
  }

  /**
   * Finds the broker of a system.
   *
   * @param systemId the system; empty if there is only one broker
   * @param clock real time
   * @param timeoutS search timeout [s]
   * @throws CommunicationException if none is found; names those of other systems
   * @throws BadInputException if several are found; lists them
   */
  public static FoundBroker theOnly(Optional<String> systemId, Clock clock, double timeoutS)
      throws InterruptedException {
    Collection<FoundBroker> all;
    try (Clock.Waiter waiter = clock.newWaiter("broker-search")) {
      all = new BrokerSearch(systemId, clock, waiter).search(timeoutS);
    } catch (IOException e) {
      throw new CommunicationException("cannot look for a broker: " + e.getMessage(), e);
    }
    List<FoundBroker> wanted =
        all.stream()
            .filter(broker -> systemId.isEmpty() || broker.carries(systemId.get()))
            .collect(Collectors.toList());
    if (wanted.size() == 1) {
      return wanted.get(0);
    }
    String whose = systemId.map(id -> " of system \"" + id + "\"").orElse("");
    if (wanted.isEmpty()) {
      throw new CommunicationException(
          String.format(
              "no broker%s announced itself by mDNS within %s s%s; does it listen to this"
                  + " network, and is it running? Its address can be named instead",
              whose, timeoutS, all.isEmpty() ? "" : "; found: " + text(all)));
    }
    throw new BadInputException(
        String.format(
            "several brokers%s announce themselves by mDNS: %s; name the system or the address"
                + " of one",
            whose, text(wanted)));
  }

  private static String text(Collection<FoundBroker> brokers) {
    return brokers.stream().map(FoundBroker::toString).sorted().collect(Collectors.joining("; "));
  }

  private Collection<FoundBroker> search(double timeoutS) throws IOException, InterruptedException {
    List<JmDNS> open = new ArrayList<>();
    try {
      IOException failure = null;
      for (InetAddress address : MulticastAddresses.all()) {
        try {
          JmDNS dns = JmDNS.create(address, "u2sa-search");
          open.add(dns);
          dns.addServiceListener(BrokerAnnouncement.TYPE, this);
        } catch (IOException e) {
          failure = e; // try the other networks
        }
      }
      if (open.isEmpty()) {
        throw failure == null ? new IOException("this host has no network") : failure;
      }
      awaitFound(timeoutS);
      return List.copyOf(found.values());
    } finally {
      endLater(open);
    }
  }

  private void awaitFound(double timeoutS) throws InterruptedException {
    long first = clock.micros() + Clock.micros(timeoutS);
    while (!isFound() && clock.micros() < first) {
      waiter.await(first);
    }
    long others = clock.micros() + Clock.micros(OTHERS_S);
    while (isFound() && clock.micros() < others) {
      waiter.await(others);
    }
  }

  private boolean isFound() {
    return found.values().stream()
        .anyMatch(broker -> systemId.isEmpty() || broker.carries(systemId.get()));
  }

  /** Closes in the background, because JmDNS takes two seconds. */
  private static void endLater(List<JmDNS> open) {
    Thread thread =
        new Thread(
            () -> {
              for (JmDNS dns : open) {
                try {
                  dns.close();
                } catch (IOException e) {
                  continue; // nothing announced, so nothing to withdraw
                }
              }
            },
            "u2sa-broker-search-end");
    thread.setDaemon(true);
    thread.start();
  }

  @Override
  public void serviceAdded(ServiceEvent event) {
    event.getDNS().requestServiceInfo(event.getType(), event.getName(), true);
  }

  @Override
  public void serviceResolved(ServiceEvent event) {
    ServiceInfo info = event.getInfo();
    String systems = info.getPropertyString(BrokerAnnouncement.SYSTEMS);
    if (systems == null || info.getInet4Addresses().length == 0) {
      return; // not a U2SA broker, or its TXT record is incomplete
    }
    String host = info.getInet4Addresses()[0].getHostAddress();
    String id = info.getPropertyString(BrokerAnnouncement.ID);
    found.putIfAbsent(
        id == null ? host + ":" + info.getPort() : id,
        new FoundBroker(
            host,
            info.getPort(),
            Arrays.stream(systems.split(",")).map(String::trim).collect(Collectors.toSet()),
            Boolean.parseBoolean(info.getPropertyString(BrokerAnnouncement.ENCRYPTED))));
    waiter.signal();
  }

  @Override
  public void serviceRemoved(ServiceEvent event) {
    waiter.signal(); // a broker that has gone is noticed on connecting
  }
}
