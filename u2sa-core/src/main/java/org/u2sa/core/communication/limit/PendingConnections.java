package org.u2sa.core.communication.limit;

import java.net.InetAddress;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Connections that have not identified themselves yet, limited in number. A new one displaces the
 * oldest of the network with the most pending connections, preferring networks without a successful
 * login, so that a flood displaces its own connections even if it uses many addresses. Legitimate
 * clients need only milliseconds. Thread-safe.
 *
 * @param <C> a connection
 */
public final class PendingConnections<C> {
  private static final int NETWORKS_REMEMBERED = 1_024;

  private final Map<C, String> waiting = new LinkedHashMap<>(); // oldest first
  private final Map<String, Boolean> known; // a set, least recently seen first; guarded by itself

  /** Starts without known networks. */
  public PendingConnections() {
    this(new RecentlyUsed<>(NETWORKS_REMEMBERED));
  }

  private PendingConnections(Map<String, Boolean> known) {
    this.known = known;
  }

  /** The connections of another port: neither displace the other's, and both know the networks. */
  public PendingConnections<C> ofAnotherPort() {
    return new PendingConnections<>(known);
  }

  /** Adds a connection, and returns those it displaces. */
  public synchronized List<C> add(C connection, InetAddress from) {
    String network = SourceNetwork.of(from);
    Map<String, List<C>> byNetwork = new LinkedHashMap<>(); // oldest first
    waiting.forEach(
        (other, its) -> byNetwork.computeIfAbsent(its, key -> new ArrayList<>()).add(other));
    List<C> same = byNetwork.getOrDefault(network, List.of());
    List<C> out = new ArrayList<>();
    if (same.size() >= BrokerLimits.PENDING_PER_ADDRESS) {
      out.add(same.get(0));
    } else if (waiting.size() >= BrokerLimits.PENDING) {
      out.add(
          byNetwork.entrySet().stream()
              .max( // the oldest on ties
                  Comparator.<Map.Entry<String, List<C>>>comparingInt(
                          entry -> isRemembered(entry.getKey()) ? 0 : 1)
                      .thenComparingInt(entry -> entry.getValue().size()))
              .orElseThrow()
              .getValue()
              .get(0));
    }
    out.forEach(waiting::remove);
    waiting.put(connection, network);
    return out;
  }

  /** Removes a connection that logged in; its network is displaced last from now on. */
  public synchronized void proven(C connection) {
    String network = waiting.remove(connection);
    if (network != null) {
      synchronized (known) {
        known.put(network, true);
      }
    }
  }

  private boolean isRemembered(String network) {
    synchronized (known) {
      return known.containsKey(network);
    }
  }

  /** Whether the network has had a successful login. */
  public boolean isKnown(InetAddress from) {
    synchronized (known) {
      return known.get(SourceNetwork.of(from)) != null; // the look-up marks it as seen
    }
  }

  /** Forgets a connection, which has logged in or ended. */
  public synchronized void remove(C connection) {
    waiting.remove(connection);
  }
}
