package org.u2sa.core.communication;

import java.net.InetAddress;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Connections that have not said yet who they are. They are few: a new one puts out the one that
 * has waited longest, of its own address if there are many from there. Who means well needs
 * milliseconds. Safe for several threads.
 */
final class Strangers {
  private final Map<ClientGate, InetAddress> waiting = new LinkedHashMap<>(); // oldest first

  /** Adds one, and returns those to put out for it. */
  synchronized List<ClientGate> add(ClientGate gate, InetAddress from) {
    List<ClientGate> sameAddress = new ArrayList<>();
    waiting.forEach(
        (other, address) -> {
          if (address.equals(from)) {
            sameAddress.add(other);
          }
        });
    List<ClientGate> out = new ArrayList<>();
    if (sameAddress.size() >= BrokerLimits.STRANGERS_PER_ADDRESS) {
      out.add(sameAddress.get(0));
    } else if (waiting.size() >= BrokerLimits.STRANGERS) {
      out.add(waiting.keySet().iterator().next());
    }
    out.forEach(waiting::remove);
    waiting.put(gate, from);
    return out;
  }

  synchronized void remove(ClientGate gate) {
    waiting.remove(gate);
  }
}
