package org.u2sa.core.communication.discovery;

import java.io.IOException;
import java.net.InetAddress;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.time.Clock;

/**
 * Finds brokers of U2SA systems on the local networks by multicast DNS. Announcements can be
 * forged; TLS authenticates the broker.
 */
public final class BrokerSearch {
  /** Placeholder for a broker's address that requests a search. */
  public static final String AUTO = "auto";

  /** How long to wait for further brokers after the first [s]. */
  private static final double OTHERS_S = 1.0;

  private final Optional<String> systemId;
  private final Clock clock;
  private final Clock.Waiter waiter;
  private final BrokerAnswers answers = new BrokerAnswers();

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
      throw new CommunicationException("cannot search for a broker: " + e.getMessage(), e);
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
              "no broker%s announced itself by mDNS within %s s%s; does it listen on this"
                  + " network, and is it running? Its address can be given instead",
              whose, timeoutS, all.isEmpty() ? "" : "; found: " + text(all)));
    }
    throw new BadInputException(
        String.format(
            "several brokers%s announce themselves by mDNS: %s; give the system or the address"
                + " of one",
            whose, text(wanted)));
  }

  private static String text(Collection<FoundBroker> brokers) {
    return brokers.stream().map(FoundBroker::toString).sorted().collect(Collectors.joining("; "));
  }

  private Collection<FoundBroker> search(double timeoutS) throws IOException, InterruptedException {
    List<MulticastLink> open = new ArrayList<>();
    try {
      IOException failure = null;
      for (InetAddress address : MulticastAddresses.all()) {
        try {
          open.add(new MulticastLink(address, clock));
        } catch (IOException e) {
          failure = e; // try the other networks
        }
      }
      if (open.isEmpty()) {
        throw failure == null ? new IOException("this host has no network") : failure;
      }
      open.forEach(this::listen);
      awaitFound(open, timeoutS);
      return answers.found();
    } finally {
      open.forEach(MulticastLink::close);
    }
  }

  private void listen(MulticastLink link) {
    Thread thread =
        new Thread(
            () -> {
              try {
                while (true) {
                  if (link.receive(Clock.NEVER).filter(answers::take).isPresent()) {
                    waiter.signal();
                  }
                }
              } catch (IOException e) {
                waiter.signal(); // closed: the search is over
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
              }
            },
            "u2sa-broker-search");
    thread.setDaemon(true);
    thread.start();
  }

  /** Asks every second until a broker is found, then for one more second for others. */
  private void awaitFound(List<MulticastLink> links, double timeoutS) throws InterruptedException {
    long end = clock.micros() + Clock.micros(timeoutS);
    long ask = clock.micros();
    boolean wasFound = false;
    while (clock.micros() < end) {
      if (!wasFound && isFound()) {
        wasFound = true;
        end = clock.micros() + Clock.micros(OTHERS_S);
      }
      if (clock.micros() >= ask) {
        ask += Clock.MICROS_PER_SECOND;
        links.forEach(this::ask);
      }
      waiter.await(Math.min(ask, end));
    }
  }

  private void ask(MulticastLink link) {
    try {
      link.send(answers.questions());
    } catch (IOException e) {
      return; // this network is away; keep asking on the others
    }
  }

  private boolean isFound() {
    return answers.found().stream()
        .anyMatch(broker -> systemId.isEmpty() || broker.carries(systemId.get()));
  }
}
