package org.u2sa.core.communication;

import java.net.InetAddress;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Connections that have not said yet who they are. They are few: a new one puts out the one that
 * has waited longest of the address with most of them, so that a flood from some addresses puts out
 * its own. Who means well needs milliseconds. Safe for several threads.
 */
final class PendingConnections {
  private final Map<ClientSession, InetAddress> waiting = new LinkedHashMap<>(); // oldest first

  /** Adds one, and returns those to put out for it. */
  synchronized List<ClientSession> add(ClientSession gate, InetAddress from) {
    Map<InetAddress, List<ClientSession>> byAddress = new LinkedHashMap<>(); // oldest first
    waiting.forEach(
        (other, address) ->
            byAddress.computeIfAbsent(address, key -> new ArrayList<>()).add(other));
    List<ClientSession> same = byAddress.getOrDefault(from, List.of());
    List<ClientSession> out = new ArrayList<>();
    if (same.size() >= BrokerLimits.STRANGERS_PER_ADDRESS) {
      out.add(same.get(0));
    } else if (waiting.size() >= BrokerLimits.STRANGERS) {
      out.add(
          byAddress.values().stream()
              .max(Comparator.comparingInt(List::size)) // of equal ones the oldest
              .orElseThrow()
              .get(0));
    }
    out.forEach(waiting::remove);
    waiting.put(gate, from);
    return out;
  }

  synchronized void remove(ClientSession gate) {
    waiting.remove(gate);
  }
}
