package org.u2sa.core.communication.discovery;

import java.io.IOException;
import java.net.InetAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import java.util.function.Consumer;
import org.u2sa.interfaces.time.Clock;

/**
 * Announces the address of this system's broker by multicast DNS, at startup and in answer to
 * queries, at most once per second. Uses one thread per network.
 */
public final class BrokerAnnouncement implements AutoCloseable {
  private static final int UNASKED = 2; // announcements at startup (RFC 6762, 8.3)

  private final Clock clock;
  private final Consumer<String> log;
  private final List<Network> networks = new ArrayList<>();

  private BrokerAnnouncement(Clock clock, Consumer<String> log) {
    this.clock = clock;
    this.log = log;
  }

  /**
   * Starts announcing. Failures are only logged, since the broker works without announcements.
   *
   * @param bindAddress address the broker listens on
   * @param clock real time
   */
  public static BrokerAnnouncement start(
      String bindAddress,
      String systemId,
      int port,
      boolean encrypted,
      Clock clock,
      Consumer<String> log) {
    BrokerAnnouncement announcement = new BrokerAnnouncement(clock, log);
    String id = UUID.randomUUID().toString();
    try {
      for (InetAddress address : MulticastAddresses.of(bindAddress)) {
        announcement.add(address, new AnnouncedBroker(systemId, address, port, encrypted, id));
      }
    } catch (IOException e) {
      log.accept("the broker is not announced by mDNS: " + e.getMessage());
    }
    return announcement;
  }

  private void add(InetAddress address, AnnouncedBroker broker) {
    try {
      Network network = new Network(address, new MulticastLink(address, clock), broker);
      networks.add(network);
      network.thread.setDaemon(true);
      network.thread.start();
    } catch (IOException e) {
      notAnnounced(address, e);
    }
  }

  private void notAnnounced(InetAddress address, IOException why) {
    log.accept(
        String.format(
            "the broker is not announced by mDNS through %s: %s",
            address.getHostAddress(), why.getMessage()));
  }

  /** Withdraws the announcement (mDNS goodbye). */
  @Override
  public void close() {
    networks.forEach(Network::end);
  }

  private final class Network {
    private final InetAddress address;
    private final MulticastLink link;
    private final AnnouncedBroker broker;
    private final Thread thread = new Thread(this::run, "u2sa-announcement");
    private boolean isFailing; // confined to the thread, like those of run

    Network(InetAddress address, MulticastLink link, AnnouncedBroker broker) {
      this.address = address;
      this.link = link;
      this.broker = broker;
    }

    private void run() {
      long dueMicros = clock.micros();
      long quietUntilMicros = dueMicros;
      int announced = 0;
      try {
        while (true) {
          long now = clock.micros();
          if (now >= dueMicros) {
            announce();
            announced++;
            quietUntilMicros = now + Clock.MICROS_PER_SECOND;
            dueMicros = announced < UNASKED ? quietUntilMicros : Clock.NEVER;
          }
          Optional<DnsMessage> message = link.receive(dueMicros);
          if (message.isPresent() && broker.isAskedForBy(message.get())) {
            dueMicros = Math.min(dueMicros, quietUntilMicros);
          }
        }
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      } catch (IOException e) {
        if (!link.isClosed()) {
          notAnnounced(address, e);
        }
      }
    }

    /** Continues after errors, because a network may be away for a while. */
    private void announce() {
      try {
        link.send(broker.announcement());
        isFailing = false;
      } catch (IOException e) {
        if (!isFailing && !link.isClosed()) {
          isFailing = true;
          notAnnounced(address, e);
        }
      }
    }

    void end() {
      try (link) {
        link.send(broker.goodbye());
      } catch (IOException e) {
        log.accept("mDNS: no goodbye through " + address.getHostAddress() + ": " + e.getMessage());
      }
    }
  }
}
