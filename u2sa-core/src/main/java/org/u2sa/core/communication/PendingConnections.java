package org.u2sa.core.communication;

import java.net.InetAddress;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Connections that have not identified themselves yet. They are few: a new one puts out the one
 * that has waited longest of the network with most of them, first of those from which nobody has
 * come in, so that a flood puts out its own, be it from many addresses. Who means well needs
 * milliseconds. Safe for several threads.
 *
 * @param <C> a connection
 */
final class PendingConnections<C> {
  private static final int NETWORKS_REMEMBERED = 1_024;

  private final Map<C, String> waiting = new LinkedHashMap<>(); // oldest first
  private final Map<String, Boolean> known = // as a set, the least lately seen first
      new RecentlyUsed<>(NETWORKS_REMEMBERED);

  /** Adds one, and returns those to put out for it. */
  synchronized List<C> add(C connection, InetAddress from) {
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
              .max( // of equal ones the oldest
                  Comparator.<Map.Entry<String, List<C>>>comparingInt(
                          entry -> known.containsKey(entry.getKey()) ? 0 : 1)
                      .thenComparingInt(entry -> entry.getValue().size()))
              .orElseThrow()
              .getValue()
              .get(0));
    }
    out.forEach(waiting::remove);
    waiting.put(connection, network);
    return out;
  }

  /** One whose password was right: others of its network are put out last from now on. */
  synchronized void proven(C connection) {
    String network = waiting.remove(connection);
    if (network != null) {
      known.put(network, true);
    }
  }

  /** Whether somebody's password from that network was right. */
  synchronized boolean isKnown(InetAddress from) {
    return known.get(SourceNetwork.of(from)) != null; // seen now
  }

  synchronized void remove(C connection) {
    waiting.remove(connection);
  }
}
